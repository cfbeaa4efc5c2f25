#pragma once

#include <string>
#include <vector>

#include "core/mechanism/graph/paper_equation.h"
#include "core/theory/ttgraph/tt_graph.h"

namespace geargraph {

/// The velocity of one link relative to another, as the paper writes it: ω₅₁, and ω₅₁'' where it is a
/// chord's.
struct VelocityName {
  int of = 0;          ///< label
  int relativeTo = 0;  ///< label
  int primes = 0;      ///< 0: a tree branch

  [[nodiscard]] std::string toText()
      const;  ///< "w51''", with two-digit labels "w12_3", from five primes on "w51(5)"
  [[nodiscard]] std::string toLatex()
      const;  ///< "\omega_{51}''", with two-digit labels "\omega_{12,3}", "\omega_{51}^{(5)}"
  friend bool operator==(const VelocityName&, const VelocityName&) = default;
};

/// The branch of a turning joint: its head relative to its tail.
[[nodiscard]] VelocityName branchName(const Digraph& graph, JointOrdinal joint);
[[nodiscard]] VelocityName tailChordName(const TerminalPair& pair);
[[nodiscard]] VelocityName headChordName(const TerminalPair& pair);

/// The names of the ratio N_tail / N_head of a mesh in both methods [AU, Eq. (44)]: i15 = n41.
struct RatioNames {
  std::string matroid;  ///< "i15"
  std::string ttGraph;  ///< "n41": tail, head; "n41'" where the same two links mesh a second time
  std::string latex;    ///< "n_{41}"
  std::string inverse;  ///< "n14" = N_head / N_tail
  std::string inverseLatex;
};
/// By mesh.
[[nodiscard]] std::vector<RatioNames> ratioNames(const Digraph& graph);

/// The numbers of the method's equations, continuing after the paper's (26), PaperEquation::gearRelation: for
/// its robot they are the paper's own. First the terminal equations, then the circuits (those of several
/// branches before the others), the circuits of engaged couplings, one step of the solution for each unknown,
/// the matrix, the ratio names, and the matrix in those names.
class EquationNumbers {
 public:
  /// @pre graph.isComplete()
  EquationNumbers(const TtGraph& graph, int unknowns);

  [[nodiscard]] int terminal(MeshOrdinal mesh) const {
    return numberOf(PaperEquation::gearRelation) + 1 + mesh;
  }
  [[nodiscard]] int tailCircuit(MeshOrdinal mesh) const {
    return m_circuits[static_cast<std::size_t>(2 * mesh)];
  }
  [[nodiscard]] int headCircuit(MeshOrdinal mesh) const {
    return m_circuits[static_cast<std::size_t>(2 * mesh) + 1];
  }
  /// By its place in TtGraph::held().
  [[nodiscard]] int heldCircuit(int place) const { return m_firstHeld + place; }
  [[nodiscard]] int step(int place) const { return m_firstStep + place; }
  [[nodiscard]] int matrix() const { return m_firstStep + m_unknowns; }
  [[nodiscard]] int names() const { return matrix() + 1; }
  [[nodiscard]] int result() const { return matrix() + 2; }

 private:
  std::vector<int> m_circuits;  ///< by chord
  int m_firstHeld = 0;
  int m_firstStep = 0;
  int m_unknowns = 0;
};

}  // namespace geargraph
