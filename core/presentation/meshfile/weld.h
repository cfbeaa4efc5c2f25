#pragma once

#include "core/machine/solids/solid.h"

namespace geargraph {

/// A mesh whose vertices have distinct positions and no normals.
struct WeldedMesh {
  std::vector<Float3> positions;
  std::vector<Triangle> triangles;
};

/// Joins vertices with equal coordinates (0 and -0 are equal), exactly, without any tolerance. Degenerate
/// triangles are removed. Vertices that a solid duplicates at creases are merged again. Cost: O(vertices) on
/// average.
[[nodiscard]] WeldedMesh welded(const Solid& solid);

/// The same, but where several pairs of triangles meet in one edge, or shells in one point, the vertices stay
/// separate: each edge of a closed solid then belongs to exactly two triangles, as formats with shared
/// vertices require of bodies that touch themselves. Pairs are matched by the order of the triangles, so that
/// consecutive shells are separated. Cost: O(triangles log triangles).
[[nodiscard]] WeldedMesh weldedToManifold(const Solid& solid);

/// The coordinates with 0 for -0, so that a bytewise comparison of equal points succeeds.
[[nodiscard]] inline Float3 withoutNegativeZeros(const Float3& p) {
  return {p[0] + 0.0F, p[1] + 0.0F, p[2] + 0.0F};
}

}  // namespace geargraph
