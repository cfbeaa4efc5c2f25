#pragma once

#include <vector>

#include "core/presentation/drawing/digraph_geometry.h"
#include "core/presentation/drawing/edge_routing.h"

namespace geargraph {

// The nodes of drawings in which links are discs, for the digraph and the T-T graph.

/// The places of the links by ordinal, on the sheet; none for a link without a position.
[[nodiscard]] Centers centersOf(const Digraph& graph, const NodePositions& positions);
/// The area of the nodes with their names, hatching and badges.
[[nodiscard]] Extent areaOf(const Centers& centers);
/// An empty sheet with the discs of the nodes on it.
[[nodiscard]] ObstacleGrid gridWithNodes(const Centers& centers);

/// The nodes with the ground's hatching where no line leaves, and with "motor" badges at free corners.
/// `taken` has discs and lines; what is placed is added to it.
[[nodiscard]] std::vector<NodePlace> placedNodes(const Mechanism& mechanism, const Digraph& graph,
                                                 const Centers& centers, ObstacleGrid& taken);
/// Places the names where there is room; to be called after everything else.
void placeNames(std::vector<NodePlace>& nodes, const Mechanism& mechanism, ObstacleGrid& taken);

[[nodiscard]] Extent hatchingExtent(const NodePlace& ground);

}  // namespace geargraph
