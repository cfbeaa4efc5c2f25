#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

#include "core/mechanism/graph/digraph.h"
#include "core/mechanism/graph/spanning_tree.h"
#include "core/theory/ttgraph/axis_levels.h"
#include "core/theory/ttgraph/transfer_vertices.h"

namespace geargraph {

/// The terminal graph of one mesh: two chords, gear i - carrier k and gear j - carrier k, marked by the same
/// number of primes [AU, Fig. 4(b), Fig. 6], and its terminal equation [AU, Eqs. (26)-(30)]
///
///     w_ik = sign * (N_j / N_i) * w_jk          i the tail gear, j the head gear
///
/// Where one of them slides in the carrier, its w is a speed along its axis.
struct TerminalPair {
  MeshOrdinal mesh = 0;
  LinkOrdinal tail = 0;
  LinkOrdinal head = 0;
  LinkOrdinal carrier = 0;
  int primes = 1;
  int sign = 0;       ///< -1: the gears turn against each other, each seen along its own axis
  int tailTeeth = 0;  ///< where a side slides, weights (MeshWeights): a two-port between turning and sliding
  int headTeeth = 0;
  int pi = 0;  ///< N_i : N_j are tailTeeth : headTeeth pi^pi
};

/// The term of a turning joint in a chord's velocity.
struct CircuitTerm {
  JointOrdinal joint = 0;
  int coefficient = 0;  ///< +1 or -1
};

/// An engaged coupling is an edge of the T-T graph whose velocity is 0: from the link that it holds to the
/// ground, or to the other link of a clutch. Its fundamental circuit gives one equation for each direction of
/// axes on the path: the sum of the branches there is 0.
struct HeldCircuit {
  ShiftElementOrdinal coupling = 0;  ///< position in the document
  std::vector<CircuitTerm> terms;
};

/// The T-T graph: tree branches with levels, and for each mesh its carrier, terminal equation and two
/// fundamental circuits. An immutable value.
class TtGraph {
 public:
  /// Cost: O(n log n + c) for walks over few levels; the circuits are computed on first use.
  /// @pre graph and tree are the mechanism's, `lines` are of its placement or empty
  TtGraph(const Mechanism& mechanism, DigraphPtr graph, SpanningTreePtr tree, const ReferenceLines& lines);

  [[nodiscard]] const Digraph& graph() const { return *m_graph; }
  [[nodiscard]] const SpanningTree& tree() const { return *m_tree; }
  [[nodiscard]] const AxisLevels& levels() const { return m_levels; }
  [[nodiscard]] const TransferVertices& transferVertices() const { return m_vertices; }

  /// By mesh; none if there is no transfer vertex or the drawn pose does not tell the sign.
  [[nodiscard]] const std::optional<TerminalPair>& terminal(MeshOrdinal mesh) const {
    return m_terminals[mesh];
  }
  /// An upper bound on the number of circuit terms, from the depths of gears and carriers. Cost: O(n + c).
  [[nodiscard]] long long longestCircuitTerms() const;
  /// Meshes that have a carrier but no sign: their axes are skew, or the pitch point of a bevel pair is not
  /// known.
  [[nodiscard]] const std::vector<int>& unsignedMeshes() const { return m_unsigned; }
  /// Every mesh has its equations.
  [[nodiscard]] bool isComplete() const { return m_complete; }

  /// The fundamental circuit of the chord of the tail gear (head gear): the chord's velocity as a sum over
  /// tree branches, from the gear to the carrier [AU, Eqs. (31)-(38)]. Thread-safe. Cost: O(1) after the
  /// first call, which costs the sum of the lengths of all walks. @pre isComplete()
  [[nodiscard]] std::span<const CircuitTerm> tailCircuit(MeshOrdinal mesh) const { return circuit(2 * mesh); }
  [[nodiscard]] std::span<const CircuitTerm> headCircuit(MeshOrdinal mesh) const {
    return circuit(2 * mesh + 1);
  }

  /// The circuits of the couplings that the document engages, in the document's order.
  [[nodiscard]] const std::vector<HeldCircuit>& held() const { return m_held; }
  /// The number of equations: c() meshes, then the circuits of the engaged couplings.
  [[nodiscard]] int equations() const { return m_graph->c() + static_cast<int>(m_held.size()); }
  /// @pre equation >= c()
  [[nodiscard]] const HeldCircuit& heldCircuit(int equation) const {
    return m_held[static_cast<std::size_t>(equation - m_graph->c())];
  }

  [[nodiscard]] Diagnostics diagnostics() const;

 private:
  /// All chords' circuits; two chords a mesh, tail and head.
  struct Circuits {
    std::once_flag written;
    std::vector<std::size_t> starts;  ///< by chord: its first term
    std::vector<CircuitTerm> terms;
  };

  [[nodiscard]] std::span<const CircuitTerm> circuit(int chord) const {
    std::call_once(m_circuits->written, [this] { writeCircuits(); });
    const auto first = m_circuits->starts[static_cast<std::size_t>(chord)];
    return std::span(m_circuits->terms)
        .subspan(first, m_circuits->starts[static_cast<std::size_t>(chord) + 1] - first);
  }
  void addTerminals(const Mechanism& mechanism, const ReferenceLines& lines);
  void addHeld(const Mechanism& mechanism, const ReferenceLines& lines);
  void writeCircuits() const;

  DigraphPtr m_graph;
  SpanningTreePtr m_tree;
  AxisLevels m_levels;
  TransferVertices m_vertices;
  ByMesh<std::optional<TerminalPair>> m_terminals;
  std::vector<int> m_unsigned;
  std::vector<HeldCircuit> m_held;
  bool m_complete = true;
  std::shared_ptr<Circuits> m_circuits = std::make_shared<Circuits>();
};

}  // namespace geargraph
