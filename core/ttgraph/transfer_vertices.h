#pragma once

#include <optional>
#include <vector>

#include "core/base/diagnostic.h"
#include "core/graph/digraph.h"
#include "core/graph/spanning_tree.h"
#include "core/ttgraph/axis_levels.h"

namespace geargraph {

/// The walk of a mesh through the tree branches, from its tail gear to its head gear, with the levels that it
/// meets [AU, the paths below Fig. 5]:
///
///     5 --b-- 0 --b-- 1 --c-- 2      nodes 5 0 1 2, word b|c, transfer vertex 1
struct MeshWalk {
  std::vector<PathStep> steps;
  std::vector<int> nodes;  ///< one more than steps
  std::vector<int> word;   ///< the levels met, repetitions dropped
  std::vector<int> turns;  ///< the positions in `nodes` where the level changes, one less than `word`
};

/// Cost: O(its length).
[[nodiscard]] MeshWalk meshWalk(const Digraph& graph, const SpanningTree& tree, const AxisLevels& levels,
                                int mesh);

/// The carrier arm of a mesh, where its walk changes level, and the axes on either side.
struct TransferVertex {
  int carrier = 0;    ///< node
  int tailLevel = 0;  ///< the level on which the tail gear turns in the carrier
  int headLevel = 0;  ///< and the head gear
};

struct TransferVertices {
  std::vector<std::optional<TransferVertex>> ofMesh;  ///< none where the mesh has no carrier
  Diagnostics diagnostics;                            ///< coaxial-mesh, no-transfer-vertex
  long long walkLength = 0;                           ///< steps of all walks together
};

/// The transfer vertex of every mesh. It is unique: the links on one level form a subtree, and two subtrees
/// of a tree that share no branch meet in one node at most.
///
/// Cost: the sum of the lengths of the walks.
[[nodiscard]] TransferVertices transferVertices(const Digraph& graph, const SpanningTree& tree,
                                                const AxisLevels& levels);

}  // namespace geargraph
