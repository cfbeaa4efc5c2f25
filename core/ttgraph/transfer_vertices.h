#pragma once

#include <optional>
#include <vector>

#include "core/base/diagnostic.h"
#include "core/graph/digraph.h"
#include "core/graph/spanning_tree.h"
#include "core/ttgraph/axis_levels.h"

namespace geargraph {

/// A stretch of a mesh's walk through the tree branches, all on one level.
struct WalkStretch {
  int level = 0;
  int from = 0;  ///< node
  int to = 0;    ///< node: where the level changes, or the head gear
};

/// The walk of a mesh from its tail gear to its head gear, stretch by stretch [AU, the paths below Fig. 5]:
///
///     5 --b-- 0 --b-- 1 --c-- 2      stretches b from 5 to 1, c from 1 to 2; word b|c, transfer vertex 1
class LevelWalks {
 public:
  /// Cost: O(n). Refers to the graph.
  LevelWalks(const Digraph& graph, const SpanningTree& tree, const AxisLevels& levels);

  /// Valid until the next one is asked for. Cost: O(stretches), however long they are.
  [[nodiscard]] const std::vector<WalkStretch>& walk(int mesh);

 private:
  /// A node's level is that of its branch towards the ground; the ground has none.
  struct Place {
    int level = -1;
    int top = -1;  ///< the ancestor that the level's branches lead to
    int topDepth = -1;
  };
  [[nodiscard]] const Place& at(int node) const { return m_places[static_cast<std::size_t>(node)]; }

  const Digraph& m_graph;
  std::vector<Place> m_places;  ///< by node
  std::vector<WalkStretch> m_up;
  std::vector<WalkStretch> m_down;
};

/// The carrier arm of a mesh, where its walk changes level, and the axes on either side.
struct TransferVertex {
  int carrier = 0;    ///< node
  int tailLevel = 0;  ///< the level on which the tail gear turns in the carrier
  int headLevel = 0;  ///< and the head gear
};

struct TransferVertices {
  std::vector<std::optional<TransferVertex>> ofMesh;  ///< none where the mesh has no carrier
  Diagnostics diagnostics;                            ///< coaxial-mesh, no-transfer-vertex
};

/// The transfer vertex of every mesh. It is unique: the links on one level form a subtree, and two subtrees
/// of a tree that share no branch meet in one node at most.
///
/// Cost: O(n) and the stretches of the walks.
[[nodiscard]] TransferVertices transferVertices(const Digraph& graph, const SpanningTree& tree,
                                                const AxisLevels& levels);

}  // namespace geargraph
