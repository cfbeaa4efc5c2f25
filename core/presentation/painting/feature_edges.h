#pragma once

#include <cstdint>
#include <vector>

#include "core/machine/solids/solid.h"

namespace geargraph::inline painting {

/// The lines that a draughtsman would draw of a solid: edges whose two faces meet at more than `crease`
/// radians, as their normals tell, and edges of one face only. Vertices are told apart by their positions,
/// bit by bit, so doubled vertices of a crease are one point.
///
/// Shape    two vertex indices a line.
/// Cost     O(triangles), once a solid.
[[nodiscard]] std::vector<std::uint32_t> featureEdges(const Solid& solid, double crease = 0.4);

}  // namespace geargraph::inline painting
