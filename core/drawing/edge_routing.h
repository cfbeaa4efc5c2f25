#pragma once

#include <optional>
#include <vector>

#include "core/drawing/obstacle_grid.h"
#include "core/graph/digraph.h"

namespace geargraph {

/// The arrow's course for every edge of the digraph, from rim to rim; none where an end has no place.
/// `nodes` holds the circles of the nodes, owned by their ordinals.
[[nodiscard]] std::vector<std::optional<Curve>> routedEdges(
    const Digraph& graph, const std::vector<std::optional<SheetPoint>>& centers, const ObstacleGrid& nodes);

/// The part of a curve between two node centres that lies outside of their rims.
[[nodiscard]] Curve trimmedAtRims(const Curve& curve);
/// The part outside of the rim of the node where it begins.
[[nodiscard]] Curve trimmedAtStart(const Curve& curve);

}  // namespace geargraph
