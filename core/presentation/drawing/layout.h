#pragma once

#include "core/presentation/drawing/digraph_geometry.h"

namespace geargraph {

/// Computes a new layout of the whole digraph: the ground on the left, every link to the right of the one
/// that carries it. Up to 300 links by Graphviz, which minimises crossings heuristically; larger drawings,
/// and all if Graphviz's plugins are missing, by the tree of the turning joints alone (tidy_tree.h). Node
/// positions are multiples of 10.
///
/// Deterministic and thread-safe; the part in Graphviz is serialised by a lock. Cost (bench): some 10 ms for
/// 10,000 links, up to about 0.1 s with Graphviz: do not call it on the GUI thread.
[[nodiscard]] NodePositions layoutOf(const Mechanism& mechanism);

/// The positions of the document and, for links that have none, places beside their neighbours as in
/// layoutOf(), away from all other nodes. A document without any positions is laid out as a whole.
[[nodiscard]] NodePositions completedPositions(const Mechanism& mechanism);

}  // namespace geargraph
