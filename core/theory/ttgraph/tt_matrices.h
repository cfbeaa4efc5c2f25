#pragma once

#include <vector>

#include "core/theory/ttgraph/tt_graph.h"

namespace geargraph::inline ttgraph {

/// One entry that is not 0: +1 or -1.
struct TtEntry {
  int column = 0;
  int value = 0;
  friend bool operator==(const TtEntry&, const TtEntry&) = default;
};

/// What closes an f-circuit of the T-T graph: a chord of a mesh, or an engaged coupling about one direction.
struct TtChordOf {
  int mesh = -1;        ///< -1: a coupling
  bool isTail = false;  ///< the chord of the mesh's tail gear, else of its head gear
  int held = -1;        ///< place in TtGraph::held(); -1: a mesh
};

/// The matrices of the T-T graph's fundamental circuits and cutsets:
///
///     f-circuits (31)-(38)   B  = [B_t | U]         a row per chord, B w = 0
///     f-cutsets  (31*)-...   Q' = [U | -B_t^T]      a row per branch, Q' M + loads = 0
///
/// Columns of both: the t branches, then the chords, of each mesh the tail gear's and the head gear's, then
/// those of the engaged couplings. A circuit tells a chord's velocity as a sum of branches, so an entry of
/// B_t is minus the coefficient in that sum; in the cutset of the branch the chord's torque has the
/// coefficient itself. B Q'^T = 0: what the torques of a cutset do at the speeds of a circuit sums to 0.
///
/// Nothing is stored: entries follow from the tree. A view of the graph, which has to live longer.
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
  /// A row of Q', by column. Cost: O(chords), and the terms of the engaged couplings.
  [[nodiscard]] std::vector<TtEntry> cutset(int branch) const;

 private:
  /// How a branch counts in the sum that is the chord's velocity; 0 where it is not between its ends.
  [[nodiscard]] int coefficient(int branch, int gear, int carrier) const;

  const TtGraph* m_graph;
};

}  // namespace geargraph::inline ttgraph
