#pragma once

#include "core/drawing/digraph_geometry.h"

namespace geargraph {

/// Lays the whole digraph out anew with Graphviz: the ground on the left, every link to the right of the one
/// that carries it, arrows crossing as little as it finds. Nodes stand on multiples of 10.
///
/// Deterministic; may be called from any thread, one call works at a time. Without Graphviz's plugins the
/// links stand in columns by their distance from the ground.
/// Cost: 1,000 links in about a fifth of a second (bench): not for the thread of the windows.
[[nodiscard]] NodePositions layoutOf(const Mechanism& mechanism);

/// The positions of the document and, for links that have none, places beside their neighbours as in
/// layoutOf(), away from all other nodes. A document without any positions is laid out as a whole.
[[nodiscard]] NodePositions completedPositions(const Mechanism& mechanism);

}  // namespace geargraph
