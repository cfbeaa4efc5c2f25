#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "core/machine/solids/solid.h"

namespace geargraph {

/// A material with its name in files. Colour in sRGB, 0..1.
struct MeshMaterial {
  std::string name;
  Float3 colour{0.7F, 0.7F, 0.7F};
  friend bool operator==(const MeshMaterial&, const MeshMaterial&) = default;
};

/// The rotation of a node relative to its parent at one time of the animation.
struct RotationKey {
  double seconds = 0;
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
};

constexpr std::size_t kNoNode = std::numeric_limits<std::size_t>::max();

/// A frame with at most one solid. Links are nodes, and so are the parts of a link.
struct MeshNode {
  std::string name;
  std::size_t parent = kNoNode;                            ///< position in MeshScene::nodes, before this one
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  ///< to the parent's frame, at rest
  std::shared_ptr<const Solid> solid;                      ///< in this node's frame; may be shared or null
  std::size_t material = 0;                                ///< position in MeshScene::materials
  /// In order of time; empty for a node at rest. A key replaces the rotation of the pose and keeps its
  /// origin; between keys the rotation is interpolated along the great arc (slerp), which is exact for a
  /// joint that turns uniformly by less than half a turn from key to key.
  std::vector<RotationKey> keys;
};

/// The content of a 3D file, independent of the format. Immutable once made.
struct MeshScene {
  std::string name;
  std::string unit = "mm";  ///< of all lengths
  std::vector<MeshMaterial> materials;
  std::vector<MeshNode> nodes;  ///< parents before children
};

/// Length of the animation: time of the last key, 0 where nothing moves.
[[nodiscard]] double durationOf(const MeshScene& scene);

/// The pose of a node relative to its parent `seconds` after the start. Before the first and after the last
/// key the rotation is constant.
[[nodiscard]] Eigen::Isometry3d poseAt(const MeshNode& node, double seconds);

/// Each node's frame to the world, in the order of the nodes: at rest, and in the animation. Cost: O(nodes).
[[nodiscard]] std::vector<Eigen::Isometry3d> worldPoses(const MeshScene& scene);
[[nodiscard]] std::vector<Eigen::Isometry3d> worldPosesAt(const MeshScene& scene, double seconds);

/// The number of triangles over all nodes, counting a shared solid once per node.
[[nodiscard]] std::size_t triangleCount(const MeshScene& scene);

/// The same scene at rest without a tree: one node for each that has a solid, its points in the world's
/// frame, computed in double and rounded once. For formats that know neither frames nor motion.
[[nodiscard]] MeshScene flattened(const MeshScene& scene);

/// The same scene below one more node with the scene's name ("mechanism" if it has none).
[[nodiscard]] MeshScene withRoot(const MeshScene& scene);

/// The same scene with distinct names: "wheel", "wheel (2)", ...; empty ones become "node". Some formats
/// refer to animated nodes by name. Cost: O(n log n).
[[nodiscard]] MeshScene withDistinctNames(MeshScene scene);

/// Metres in one `unit` of a document; that of millimetres if the unit is none of um, mm, cm, dm, m, in, ft.
[[nodiscard]] double metresPerUnit(const std::string& unit);

}  // namespace geargraph
