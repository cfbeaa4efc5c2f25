#pragma once

#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "core/foundations/exact/expansion.h"
#include "core/theory/matroid/coefficient_matrix.h"

namespace geargraph {

/// One line of the substitution: theta_joint = sum of coefficient * theta over joints that are known by then
/// (inputs, and joints of earlier lines).
struct SymbolicLine {
  struct Term {
    JointOrdinal joint = 0;
    RationalFunction coefficient;
  };
  JointOrdinal joint = 0;
  int equation =
      -1;  ///< the mesh, or row of a coupling, that gives it; -1 where elimination combined several
  std::vector<Term> terms;
};

/// A mechanism solved for its inputs in the gear ratios i_k = N_tail / N_head [AU, Eqs. (24), (25)].
///
/// Where ratios coincide so that a mesh is redundant for these teeth only, the equations of independent
/// meshes are solved: true for these teeth and for all others that leave the mechanism its freedom.
struct SymbolicSolution {
  RatioRingPtr ring;         ///< variable m is the ratio of mesh m, "i15"
  std::vector<int> inputs;   ///< joints, in column order
  std::vector<int> outputs;  ///< the other joints, by label
  std::vector<SymbolicLine> lines;
  /// theta_outputs = matrix * theta_inputs, row by row; none for an entry that exceeded the budget: `lines`
  /// still define it.
  std::vector<std::optional<RationalFunction>> matrix;
  int skipped = 0;  ///< entries that exceeded the budget
};

/// The ring of the mechanism's ratios with their values, without powers of pi: where a side slides, a
/// function that is 0 at these is 0 at the ratios themselves (KinematicModel::piOf()).
[[nodiscard]] RatioRingPtr ratioRingOf(const Mechanism& mechanism);

/// std::nullopt if `stop` was requested, or the coupled core of the equations alone exceeded the budget.
/// `equations`: independent ones, r of them (MatroidAnalysis::independentEquations()).
/// @pre the inputs are valid
[[nodiscard]] std::optional<SymbolicSolution> solveSymbolic(
    const Mechanism& mechanism, const KinematicModel& model, const CoefficientMatrix& matrix,
    std::span<const int> equations, std::span<const int> inputs, const std::stop_token& stop = {},
    ExpansionBudget budget = {});

}  // namespace geargraph
