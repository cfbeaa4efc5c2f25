#pragma once

#include <vector>

#include "core/theory/ttgraph/tt_graph.h"

namespace geargraph {

/// A nonzero entry: +1 or -1.
struct TtEntry {
  int column = 0;
  int value = 0;
  friend bool operator==(const TtEntry&, const TtEntry&) = default;
};

/// The chord of an f-circuit of the T-T graph: of a mesh, or of an engaged coupling for one axis direction.
struct TtChordOf {
  MeshOrdinal mesh = -1;  ///< -1: a coupling
  bool isTail = false;    ///< the chord of the mesh's tail gear, else of its head gear
  int held = -1;          ///< position in TtGraph::held(); -1: a mesh
};

/// The matrices of the fundamental circuits and cutsets of the T-T graph:
///
///     f-circuits (31)-(38)   B  = [B_t | U]         a row per chord, B w = 0
///     f-cutsets  (31*)-...   Q' = [U | -B_t^T]      a row per branch, Q' M + loads = 0
///
/// Columns of both: the t branches, then the chords: for each mesh those of the tail gear and the head gear,
/// then those of the engaged couplings. A circuit expresses a chord's velocity as a sum over branches, so an
/// entry of B_t is minus the coefficient in that sum; in the cutset of the branch the chord's torque has the
/// coefficient itself. B Q'^T = 0: the torques of a cutset have no power at the speeds of a circuit.
///
/// Nothing is stored: entries are computed from the tree. A view of the graph, which must outlive it.
class TtMatrices {
 public:
  /// @pre graph.isComplete()
  explicit TtMatrices(const TtGraph& graph) : m_graph(&graph) {}

  [[nodiscard]] int branches() const { return m_graph->graph().t(); }
  [[nodiscard]] int chords() const {
    return 2 * m_graph->graph().c() + static_cast<int>(m_graph->held().size());
  }
  [[nodiscard]] int columns() const { return branches() + chords(); }
  [[nodiscard]] TtChordOf chord(int chord) const;

  /// A row of B, by column. Cost: O(length of the circuit).
  [[nodiscard]] std::vector<TtEntry> circuit(int chord) const;
  /// A row of Q', by column. Cost: O(chords + terms of the engaged couplings).
  [[nodiscard]] std::vector<TtEntry> cutset(int branch) const;

 private:
  /// The coefficient of a branch in the sum for the chord's velocity; 0 if it is not on the path between its
  /// ends.
  [[nodiscard]] int coefficient(int branch, LinkOrdinal gear, LinkOrdinal carrier) const;

  const TtGraph* m_graph;
};

}  // namespace geargraph
