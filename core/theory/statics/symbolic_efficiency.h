#pragma once

#include <optional>
#include <span>
#include <stop_token>

#include "core/theory/statics/losses.h"

namespace geargraph {

/// The data from which the efficiency of a solved train follows.
struct EfficiencyProblem {
  std::span<const int> meshes;            ///< independent ones, also of the rows of engaged couplings
  std::span<const int> inputs;            ///< joints that drive, at `speeds`
  std::span<const Rational> speeds;       ///< of the inputs
  std::span<const RadicalColumns> loads;  ///< by load, its power for unit speeds, by link
};

/// Power taken over power fed as a function of the gear ratios i_k and the efficiencies eta_k of the meshes
/// that lose power, "(i9*i10 + eta9*eta10)/(i9*i10 + 1)": speeds and torques are solved over such functions,
/// with the drivers of the accepted pattern. Which gear drives is that of these teeth; the function holds as
/// long as the pattern does.
///
/// std::nullopt if `stop` was requested, the function exceeded `mostTerms` terms, directions or efficiencies
/// are irrational, meshes share loads indeterminately, engaged couplings are redundant, or nothing is fed.
/// Cost: two eliminations over functions.
/// @pre solution.outcome is solved
[[nodiscard]] std::optional<RationalFunction> symbolicEfficiency(
    const Mechanism& mechanism, const KinematicModel& model, const EfficiencyProblem& problem,
    const LossySolution& solution, const Motion& motion, const std::stop_token& stop = {},
    std::int64_t mostTerms = 200);

}  // namespace geargraph
