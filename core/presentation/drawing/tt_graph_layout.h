#pragma once

#include "core/presentation/drawing/digraph_geometry.h"
#include "core/theory/ttgraph/tt_graph.h"

namespace geargraph::inline drawing {

/// Lays the T-T graph out as a tree that hangs from the ground [AU, Figs. 5 and 6]: a rank for each distance
/// from the ground, links of one parent in the order that keeps the gears of a mesh beside each other, and
/// room for the chords beside the branches. Links that no joint ties to the ground hang from roots of their
/// own, to the right. Nodes stand on multiples of 10, the ground at (0, 0), farther apart where labels would
/// find no room (looked at for graphs of up to kMostLinesChecked lines).
///
/// `graph` says where chords run; null where the turning joints are no spanning tree.
/// Cost: near linear in links + joints + meshes.
/// @pre `graph`, if any, is the mechanism's
constexpr std::size_t kMostLinesChecked = 200;
[[nodiscard]] NodePositions ttLayout(const Mechanism& mechanism, const TtGraph* graph);

/// The places that somebody has chosen, and those of the layout for the others, moved aside where a chosen
/// one stands.
[[nodiscard]] NodePositions ttPositions(NodePositions layout, const NodePositions& chosen);

}  // namespace geargraph::inline drawing
