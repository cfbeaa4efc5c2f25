#pragma once

#include "core/machine/solids/solid.h"

namespace geargraph::inline meshfile {

/// A mesh whose vertices differ in position, and no more.
struct WeldedMesh {
  std::vector<Float3> positions;
  std::vector<Triangle> triangles;
};

/// Joins vertices with equal coordinates (0 and -0 are equal), exactly: no distance is tolerated. Triangles
/// that lose a corner go. What a solid duplicates at creases is one again. Cost: O(vertices) on average.
[[nodiscard]] WeldedMesh welded(const Solid& solid);

/// The same, but where several pairs of triangles meet in one edge, or shells in one point, the vertices stay
/// apart: each edge of a closed solid then belongs to exactly two triangles, as formats with shared vertices
/// demand of bodies that touch themselves. Pairs are told by the order of the triangles, so shells that came
/// one after the other part. Cost: O(triangles log triangles).
[[nodiscard]] WeldedMesh weldedToManifold(const Solid& solid);

/// The coordinates with 0 for -0, so that a reader who compares bytes finds equal points equal.
[[nodiscard]] inline Float3 withoutNegativeZeros(const Float3& p) {
  return {p[0] + 0.0F, p[1] + 0.0F, p[2] + 0.0F};
}

}  // namespace geargraph::inline meshfile
