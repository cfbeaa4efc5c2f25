#pragma once

#include <memory_resource>
#include <optional>
#include <vector>

#include "core/foundations/base/diagnostic.h"
#include "core/mechanism/graph/digraph.h"
#include "core/mechanism/graph/spanning_tree.h"
#include "core/theory/ttgraph/axis_levels.h"

namespace geargraph {

/// A stretch of a mesh's walk through the tree branches, all on one level.
struct WalkStretch {
  int level = 0;
  int from = 0;  ///< node
  int to = 0;    ///< node: where the level changes, or the head gear
};

/// The carrier arm of a mesh, where its walk changes level, and the axes on either side.
struct TransferVertex {
  LinkOrdinal carrier = 0;  ///< node
  int tailLevel = 0;        ///< the level on which the tail gear turns in the carrier
  int headLevel = 0;        ///< and the head gear
};

/// The walk of a mesh from its tail gear to its head gear, stretch by stretch [AU, the paths below Fig. 5]:
///
///     5 --b-- 0 --b-- 1 --c-- 2      stretches b from 5 to 1, c from 1 to 2; word b|c, transfer vertex 1
class LevelWalks {
 public:
  /// Cost: O(n). Refers to graph and tree.
  LevelWalks(const Digraph& graph, const SpanningTree& tree, const AxisLevels& levels,
             std::pmr::memory_resource* memory = std::pmr::get_default_resource());

  /// Cost: O(stretches), however long they are.
  [[nodiscard]] std::vector<WalkStretch> walk(MeshOrdinal mesh) const;

  /// The vertex where a walk of two stretches changes level; std::nullopt if it has fewer or more. Cost:
  /// O(1).
  [[nodiscard]] std::optional<TransferVertex> transferVertex(MeshOrdinal mesh) const;

 private:
  /// A node's level is that of its branch towards the ground; the ground has none.
  struct Place {
    int level = -1;
    LinkOrdinal rootLink = -1;  ///< the level's root link: the ancestor that its branches lead to
  };
  [[nodiscard]] const Place& at(LinkOrdinal node) const { return m_places[static_cast<std::size_t>(node)]; }
  [[nodiscard]] int levelOfBoth(int a, int b) const;

  const Digraph& m_graph;
  const SpanningTree& m_tree;
  std::pmr::vector<Place> m_places;  ///< by node
};

struct TransferVertices {
  ByMesh<std::optional<TransferVertex>> ofMesh;  ///< none if the mesh has no carrier
  Diagnostics diagnostics;                       ///< coaxial-mesh, no-transfer-vertex
};

/// The transfer vertex of every mesh. It is unique: the links on one level form a subtree, and two subtrees
/// of a tree that share no branch have at most one node in common.
///
/// Cost: O(n + c), and the walks of meshes without one.
[[nodiscard]] TransferVertices transferVertices(const Digraph& graph, const SpanningTree& tree,
                                                const AxisLevels& levels);

}  // namespace geargraph
