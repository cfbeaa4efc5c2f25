#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <vector>

namespace geargraph::inline solids {

using Float3 = std::array<float, 3>;
using Triangle = std::array<std::uint32_t, 3>;

/// An indexed triangle mesh, as graphics memory and STL take it: `positions.data()`, `normals.data()` and
/// `triangles.data()` are plain arrays of three numbers each.
///
/// Normals  one unit normal a vertex, outward. At a crease (a real edge of the part) the vertex is there once
/// for
///          each side, with bit-equal position, so that equality of positions welds the mesh exactly.
/// Triangles counter-clockwise seen from outside. A solid of this layer is closed and 2-manifold once welded.
/// Units    those of whoever made it; mechanisms use the document's unit.
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

/// Puts `part`, moved by `placed`, beside what `whole` already holds. The two stay separate shells.
void append(Solid& whole, const Solid& part, const Eigen::Isometry3d& placed = Eigen::Isometry3d::Identity());

/// The solid moved to another place. Equal positions stay equal, so it stays closed.
[[nodiscard]] Solid moved(const Solid& solid, const Eigen::Isometry3d& placed);

}  // namespace geargraph::inline solids
