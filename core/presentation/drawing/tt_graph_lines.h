#pragma once

#include <string>
#include <vector>

#include "core/theory/ttgraph/tt_graph.h"

namespace geargraph {

/// The meaning of a line of the T-T graph.
enum class TtLine {
  branch,     ///< a turning joint: a branch of the tree
  tailChord,  ///< tail gear - carrier of a mesh
  headChord,  ///< head gear - carrier
  open,       ///< a mesh without a transfer vertex: from gear to gear, not yet part of the graph
};

/// A line from node i to node k, whose terminal variable is w_ik, the velocity of i relative to k: a branch
/// runs from the head of its joint to the tail, a chord from the gear to the carrier [AU, Fig. 4].
struct TtGraphLine {
  TtLine kind = TtLine::branch;
  int from = 0;       ///< node
  int to = 0;         ///< node
  int edge = 0;       ///< of the digraph
  std::string label;  ///< "b": the level; "16''" with a prime for each mesh so far, "19(5)" from five on
};

/// Branches first, in the order of the joints, then the meshes' lines. Without a T-T graph (the turning
/// joints are no spanning tree) all meshes are open, and branches are labelled with the axes' names in the
/// document.
/// @pre `graph`, if any, is of this digraph
[[nodiscard]] std::vector<TtGraphLine> ttGraphLines(const Mechanism& mechanism, const Digraph& digraph,
                                                    const TtGraph* graph);

}  // namespace geargraph
