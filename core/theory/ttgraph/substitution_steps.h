#pragma once

#include <optional>
#include <stop_token>
#include <vector>

#include "core/theory/ttgraph/notation.h"
#include "core/theory/ttgraph/tt_solution.h"

namespace geargraph::inline ttgraph {

/// A joint's part in the equation of another.
struct SolvedTerm {
  int joint = 0;
  RationalFunction coefficient;
};

/// One equation of the chain (39)-(42) [AU]: an unknown, where it comes from, and what it comes to.
///
///     w21 = n52 w10 - n52 w50              before: the mesh's equations solved for the unknown
///         = -n52 n41 w40 - n52 w50         after: earlier steps put in, over the inputs
struct SubstitutionStep {
  int number = 0;  ///< of this equation
  int joint = 0;   ///< the unknown
  /// Meshes, and from c() on engaged couplings, that give it; several where they had to be solved together.
  std::vector<int> equations;
  bool coupled = false;   ///< solved together
  std::vector<int> uses;  ///< numbers of the equations put in, as the paper cites them
  std::vector<SolvedTerm> before;
  std::vector<std::optional<RationalFunction>> after;  ///< by input; none where over the budget
};

/// The whole chain, in order: a step for each unknown, but for coupled ones whose elimination grows beyond
/// reading, and none where the plan is by levels. `solution` is ttSymbolicSolution() over the same ring.
/// None where `stop` was requested.
[[nodiscard]] std::optional<std::vector<SubstitutionStep>> substitutionSteps(
    const RatioRingPtr& ring, const TtGraph& graph, const SubstitutionPlan& plan,
    const RateMatrix<std::optional<RationalFunction>>& solution, const std::stop_token& stop = {});

}  // namespace geargraph::inline ttgraph
