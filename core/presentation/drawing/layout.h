#pragma once

#include "core/presentation/drawing/digraph_geometry.h"

namespace geargraph::inline drawing {

/// Lays the whole digraph out anew: the ground on the left, every link to the right of the one that carries
/// it. Up to 300 links Graphviz does it, with arrows that cross as little as it finds; larger drawings, and
/// all where Graphviz's plugins are missing, follow the tree of the turning joints alone (tidy_tree.h). Nodes
/// stand on multiples of 10.
///
/// Deterministic; may be called from any thread, Graphviz's part by one at a time.
/// Cost (bench): some 10 ms for 10,000 links, up to about 0.1 s for those that Graphviz lays out: not for the
/// thread of the windows.
[[nodiscard]] NodePositions layoutOf(const Mechanism& mechanism);

/// The positions of the document and, for links that have none, places beside their neighbours as in
/// layoutOf(), away from all other nodes. A document without any positions is laid out as a whole.
[[nodiscard]] NodePositions completedPositions(const Mechanism& mechanism);

}  // namespace geargraph::inline drawing
