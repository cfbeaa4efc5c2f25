#pragma once

#include <vector>

#include "core/presentation/drawing/display_list.h"
#include "core/presentation/drawing/emphasis.h"
#include "core/presentation/drawing/node_placement.h"

namespace geargraph {

/// Places the couplings of links that have a place themselves. `taken` has the nodes with their badges and
/// the arrows; the placed couplings are added to it. Cost: O(couplings).
[[nodiscard]] std::vector<ShiftElementPlace> placedCouplings(const Mechanism& mechanism, const Digraph& graph,
                                                             const Centers& centers,
                                                             const std::vector<NodePlace>& nodes,
                                                             ObstacleGrid& taken);

/// The extent of the plates and the name.
[[nodiscard]] Extent couplingExtent(const ShiftElementPlace& place);

/// The marks of a coupling, with two outlines: of the line, and of plates and name.
[[nodiscard]] DisplayList couplingDrawing(const ShiftElementPlace& place, const Emphasis& emphasis);

}  // namespace geargraph
