#pragma once

#include <vector>

#include "core/presentation/drawing/digraph_geometry.h"
#include "core/presentation/drawing/edge_routing.h"

namespace geargraph::inline drawing {

// The nodes of a drawing in which links are discs: what the digraph and the T-T graph have in common.

/// The places of the links by ordinal, on the sheet; none where a link has no position.
[[nodiscard]] Centers centersOf(const Digraph& graph, const NodePositions& positions);
/// The area that the nodes and what stands by them take.
[[nodiscard]] Extent areaOf(const Centers& centers);
/// An empty sheet with the discs of the nodes on it.
[[nodiscard]] ObstacleGrid gridWithNodes(const Centers& centers);

/// The nodes with what belongs to them: the ground's hatching where no line leaves, "motor" badges at corners
/// that are free. `taken` holds discs and lines, and gets what is placed.
[[nodiscard]] std::vector<NodePlace> placedNodes(const Mechanism& mechanism, const Digraph& graph,
                                                 const Centers& centers, ObstacleGrid& taken);
/// Names where there is room for them: last of all.
void placeNames(std::vector<NodePlace>& nodes, const Mechanism& mechanism, ObstacleGrid& taken);

[[nodiscard]] Extent hatchingExtent(const NodePlace& ground);

}  // namespace geargraph::inline drawing
