#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/mechanism/graph/digraph.h"
#include "core/presentation/drawing/obstacle_grid.h"

namespace geargraph {

using Centers = std::vector<std::optional<CanvasPoint>>;  ///< of nodes, by ordinal

/// An arrow's course, from rim to rim, and how large a detour was searched until it was found.
struct Course {
  Curve curve;
  int looked = 0;
  double height = 0;  ///< initial sideways offset, because of other arrows of the same two links, px
};
using Courses = std::vector<std::optional<Course>>;  ///< of edges, by ordinal; none if an end has no place

/// The arrow's course for every edge of the digraph. `nodes` holds the circles of the nodes, owned by their
/// ordinals.
[[nodiscard]] Courses routedEdges(const Digraph& graph, const Centers& centers, const ObstacleGrid& nodes);

/// The same for any lines between nodes, each with an initial sideways `offset`, px, to the left seen from
/// its tail on the sheet.
[[nodiscard]] Courses routedEdges(std::span<const DigraphEdge> edges, const std::vector<double>& offsets,
                                  const Centers& centers, const ObstacleGrid& nodes);

/// The same, faster: `former` holds the courses of arrows that ran between the same two links before, and
/// `moved` the old and new places of nodes that have moved since. A course is reused where none of these can
/// affect it.
[[nodiscard]] Courses reroutedEdges(const Digraph& graph, const Centers& centers, const ObstacleGrid& nodes,
                                    const std::vector<CanvasPoint>& moved, const Courses& former);

/// The part of a curve between two node centres that is outside their rims.
[[nodiscard]] Curve trimmedAtRims(const Curve& curve);
/// The part outside the rim of the node where it begins.
[[nodiscard]] Curve trimmedAtStart(const Curve& curve);

}  // namespace geargraph
