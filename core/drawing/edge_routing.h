#pragma once

#include <optional>
#include <vector>

#include "core/drawing/obstacle_grid.h"
#include "core/graph/digraph.h"

namespace geargraph {

using Centers = std::vector<std::optional<SheetPoint>>;  ///< of nodes, by ordinal

/// An arrow's course, from rim to rim, and how far round detours were looked for until it was found.
struct Course {
  Curve curve;
  int looked = 0;
};
using Courses = std::vector<std::optional<Course>>;  ///< of edges, by ordinal; none where an end has no place

/// The arrow's course for every edge of the digraph. `nodes` holds the circles of the nodes, owned by their
/// ordinals.
[[nodiscard]] Courses routedEdges(const Digraph& graph, const Centers& centers, const ObstacleGrid& nodes);

/// The same, faster: what was found for the same digraph with its nodes at `formerCenters` is taken over
/// where no node that has moved could make a difference.
[[nodiscard]] Courses reroutedEdges(const Digraph& graph, const Centers& centers, const ObstacleGrid& nodes,
                                    const Centers& formerCenters, const Courses& former);

/// The part of a curve between two node centres that lies outside of their rims.
[[nodiscard]] Curve trimmedAtRims(const Curve& curve);
/// The part outside of the rim of the node where it begins.
[[nodiscard]] Curve trimmedAtStart(const Curve& curve);

}  // namespace geargraph
