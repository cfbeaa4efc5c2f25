#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <vector>

namespace geargraph {

using Float3 = std::array<float, 3>;
using Triangle = std::array<std::uint32_t, 3>;

/// An indexed triangle mesh, in the layout of graphics memory and STL: `positions.data()`, `normals.data()`
/// and `triangles.data()` are plain arrays of three numbers each.
///
/// Normals one outward unit normal per vertex. At a crease (a real edge of the part) there is one vertex for
/// each side, with bitwise equal positions, so that welding equal positions closes the mesh exactly.
/// Triangles counter-clockwise seen from outside. A solid of this layer is closed and 2-manifold once welded.
/// Units    the caller's; solids of mechanisms use the document's unit.
struct Solid {
  std::vector<Float3> positions;
  std::vector<Float3> normals;
  std::vector<Triangle> triangles;

  [[nodiscard]] bool empty() const { return triangles.empty(); }
  friend bool operator==(const Solid&, const Solid&) = default;
};

/// Volume enclosed by a closed mesh, positive where its triangles face outward. Cost: O(triangles).
[[nodiscard]] double signedVolume(const Solid& solid);

/// Smallest and largest coordinates; empty (min > max) for an empty solid.
[[nodiscard]] Eigen::AlignedBox3d boundsOf(const Solid& solid);

/// Appends `part`, displaced by `placed`, to `whole` as a separate shell.
void append(Solid& whole, const Solid& part, const Eigen::Isometry3d& placed = Eigen::Isometry3d::Identity());

/// The solid displaced by `placed`. Equal positions stay equal, so it stays closed.
[[nodiscard]] Solid moved(const Solid& solid, const Eigen::Isometry3d& placed);

}  // namespace geargraph
