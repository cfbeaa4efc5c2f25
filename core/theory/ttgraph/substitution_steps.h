#pragma once

#include <optional>
#include <stop_token>
#include <vector>

#include "core/theory/ttgraph/notation.h"
#include "core/theory/ttgraph/tt_solution.h"

namespace geargraph::inline ttgraph {

/// A term of another joint's equation.
struct SolvedTerm {
  JointOrdinal joint = 0;
  RationalFunction coefficient;
};

/// One equation of the chain (39)-(42) [AU]: an unknown, the equations that give it, and its result.
///
///     w21 = n52 w10 - n52 w50              before: the mesh's equations solved for the unknown
///         = -n52 n41 w40 - n52 w50 after: earlier steps substituted, over the inputs
struct SubstitutionStep {
  int number = 0;          ///< of this equation
  JointOrdinal joint = 0;  ///< the unknown
  /// Meshes, and from c() on engaged couplings, that give it; several where they had to be solved together.
  std::vector<int> equations;
  bool coupled = false;   ///< solved together
  std::vector<int> uses;  ///< numbers of the substituted equations, as the paper cites them
  std::vector<SolvedTerm> before;
  std::vector<std::optional<RationalFunction>> after;  ///< by input; none for one that exceeded the budget
};

/// The whole chain, in order: a step for each unknown, except coupled ones whose elimination exceeds the
/// budget; empty where the plan is by levels. `solution` is ttSymbolicSolution() over the same ring.
/// std::nullopt if `stop` was requested.
[[nodiscard]] std::optional<std::vector<SubstitutionStep>> substitutionSteps(
    const RatioRingPtr& ring, const TtGraph& graph, const SubstitutionPlan& plan,
    const RateMatrix<std::optional<RationalFunction>>& solution, const std::stop_token& stop = {});

}  // namespace geargraph::inline ttgraph
