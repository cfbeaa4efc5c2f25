#pragma once

#include <span>
#include <vector>

#include "core/theory/matroid/coefficient_matrix.h"
#include "core/theory/ttgraph/tt_graph.h"

namespace geargraph {

/// The f-cutsets of the spanning tree as equations of the torques about the joints' axes, (19*):
///
///     tau_e + ell_e = sum over meshes c of P(c, e) F_c            (column e of P)
///
/// one for each turning joint e: the meshes whose cycle contains the joint. They are the rows Q = [U | -T^T]
/// of the cutset matrix, read with the moments of the mesh forces about the joints: Q C^T = 0, because a
/// cutset crosses a cycle in as many edges along its direction as against it.
///
/// tau_e is the torque in joint e, by its tail on its head, about +direction of its axis (N m); ell_e the
/// power of the loads on links beyond the joint for the joint's rate 1; F_c the tangential force of mesh c
/// along e_c, by the tail's gear on the head's (N, for P in metres). A force along the line of centres or
/// along an axis of the mesh is reciprocal to every joint screw of the cycle: it does no work and appears in
/// no equation.
class CutsetEquations {
 public:
  struct Term {
    MeshOrdinal mesh = 0;
    bool tail = false;  ///< the joint is on the tail's axis: factor i in a normalised row, else 1
    int sign = 1;       ///< of the entry in the normalised row
    double length = 0;  ///< P(c, e), in the document's unit
  };

  /// Cost: the sum of the cycles' lengths.
  explicit CutsetEquations(const CoefficientMatrix& matrix);

  /// The same by the T-T graph's own route, without P: the f-cutsets of its branches, with the coefficients
  /// of the circuits (31)-(38) and the terminal equations' duals (26*). f_c is the torque of mesh c on the
  /// head's gear, up to a sign of the mesh; lengths are 0. Cost: the circuit terms.
  /// @pre graph.isComplete()
  explicit CutsetEquations(const TtGraph& graph);

  /// By mesh, ascending.
  [[nodiscard]] std::span<const Term> terms(JointOrdinal joint) const {
    const auto first = m_starts[joint];
    return std::span(m_terms).subspan(first, m_starts[static_cast<std::size_t>(joint) + 1] - first);
  }
  [[nodiscard]] int count() const { return static_cast<int>(m_starts.size()) - 1; }

 private:
  ByJoint<std::size_t> m_starts;  ///< and one for the end
  std::vector<Term> m_terms;
};

}  // namespace geargraph
