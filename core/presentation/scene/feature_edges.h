#pragma once

#include <cstdint>
#include <vector>

#include "core/machine/solids/solid.h"

namespace geargraph {

/// The feature edges of a solid: edges whose two faces differ by more than `crease` radians, by their
/// normals, and edges of one face only. Vertices with bitwise equal positions are one point, so the doubled
/// vertices of a crease are merged.
///
/// Shape    two vertex indices per line.
/// Cost     O(triangles).
[[nodiscard]] std::vector<std::uint32_t> featureEdges(const Solid& solid, double crease = 0.4);

}  // namespace geargraph
