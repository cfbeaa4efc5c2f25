#pragma once

#include <vector>

#include "core/presentation/drawing/display_list.h"
#include "core/presentation/drawing/emphasis.h"
#include "core/presentation/drawing/node_placement.h"

namespace geargraph::inline drawing {

/// Places for the couplings whose links have one. `nodes` are placed; `taken` holds them with their badges,
/// and arrows, and gets what is placed. Cost: O(couplings).
[[nodiscard]] std::vector<CouplingPlace> placedCouplings(const Mechanism& mechanism, const Digraph& graph,
                                                         const Centers& centers,
                                                         const std::vector<NodePlace>& nodes,
                                                         ObstacleGrid& taken);

/// Plates and name.
[[nodiscard]] Extent couplingExtent(const CouplingPlace& place);

/// Two outlines each: of the line, and of plates and name.
[[nodiscard]] DisplayList couplingDrawing(const CouplingPlace& place, const Emphasis& emphasis);

}  // namespace geargraph::inline drawing
