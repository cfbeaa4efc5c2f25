#pragma once

#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "core/foundations/exact/pi_number.h"
#include "core/theory/matroid/live_solution.h"

namespace geargraph {

/// A mechanism solved for its inputs in fractions [AU, Eqs. (22), (23)].
struct ExactSolution {
  std::vector<int> inputs;   ///< joints, in column order
  std::vector<int> outputs;  ///< the other joints, by label
  std::vector<Rational>
      matrix;  ///< theta_outputs = matrix * theta_inputs, row by row; empty above kMaxExactEntries
  ByJoint<Rational> rates;  ///< for the given speeds, rad/s

  static constexpr std::size_t kMaxExactEntries = 250'000;
};

/// The same where a row ties a length to an angle by a power of pi (KinematicModel::hasPi()).
struct PiSolution {
  std::vector<int> inputs;       ///< joints, in column order
  std::vector<int> outputs;      ///< the other joints, by label
  std::vector<PiNumber> matrix;  ///< row by row; empty above ExactSolution::kMaxExactEntries
  ByJoint<PiNumber> rates;       ///< for the given speeds, rad/s or lengths a second
};

/// std::nullopt if `stop` was requested, or a row has a power of pi (solvePi()).
/// @pre the inputs are valid (chooseInputs(), solveLive()); a speed for each
/// Cost: near linear in n + c, times E, times the size of the fractions that arise.
[[nodiscard]] std::optional<ExactSolution> solveExact(const KinematicModel& model,
                                                      std::span<const int> inputs,
                                                      std::span<const Rational> speeds,
                                                      const std::stop_token& stop = {});

/// The same for any model without a mixedEquation(): eliminated in fractions, the powers of pi put back.
[[nodiscard]] std::optional<PiSolution> solvePi(const KinematicModel& model, std::span<const int> inputs,
                                                std::span<const Rational> speeds,
                                                const std::stop_token& stop = {});

}  // namespace geargraph
