#pragma once

#include "core/presentation/drawing/digraph_geometry.h"
#include "core/theory/ttgraph/tt_graph.h"

namespace geargraph {

/// With more lines ttLayout() does not check whether labels find room.
constexpr std::size_t kMaxLinesChecked = 200;
/// Lays the T-T graph out as a tree below the ground [AU, Figs. 5 and 6]: a rank for each distance from the
/// ground, links of one parent in the order that keeps the gears of a mesh adjacent, and room for the chords
/// beside the branches. Links that no joint connects to the ground have roots of their own, to the right.
/// Positions are multiples of 10, the ground at (0, 0), farther apart where labels would find no room
/// (checked for graphs of up to kMaxLinesChecked lines).
///
/// `graph` says where chords run; null where the turning joints are no spanning tree.
/// Cost: near linear in links + joints + meshes.
/// @pre `graph`, if any, is the mechanism's
[[nodiscard]] NodePositions ttLayout(const Mechanism& mechanism, const TtGraph* graph);

/// The places `chosen` by the user, and those of `layout` for the other nodes, moved aside from chosen ones.
[[nodiscard]] NodePositions ttPositions(NodePositions layout, const NodePositions& chosen);

}  // namespace geargraph
