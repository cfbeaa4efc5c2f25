#pragma once

#include <optional>
#include <stop_token>
#include <vector>

#include "core/theory/ttgraph/notation.h"
#include "core/theory/ttgraph/tt_solution.h"

namespace geargraph {

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
  /// Behind the equation of a step with `inner` stands the one that gives the inner joint.
  std::vector<int> equations;
  bool coupled = false;  ///< solved together
  /// The joint whose equation is put in though it has no number yet: w72 in (41), -1 for none.
  JointOrdinal inner = -1;
  /// The number of the step with this inner joint, whose first equation gives it the other way round: (41)
  /// gives w72 in (42). 0 for none.
  int turned = 0;
  std::vector<int> uses;  ///< numbers of the substituted equations, as the paper cites them
  std::vector<SolvedTerm> before;
  std::vector<std::optional<RationalFunction>> after;  ///< by input; none for one that exceeded the budget
};

/// The whole chain: a step for each unknown, except coupled ones whose elimination exceeds the budget; empty
/// where the plan is by levels. In the order of the links, as in the paper, as far as a step has at most one
/// unknown that is not solved yet, which itself needs none; the plan's order otherwise; coupled ones last.
/// `solution` is ttSymbolicSolution() over the same ring. std::nullopt if `stop` was requested.
[[nodiscard]] std::optional<std::vector<SubstitutionStep>> substitutionSteps(
    const RatioRingPtr& ring, const TtGraph& graph, const SubstitutionPlan& plan,
    const RateMatrix<std::optional<RationalFunction>>& solution, const std::stop_token& stop = {});

}  // namespace geargraph
