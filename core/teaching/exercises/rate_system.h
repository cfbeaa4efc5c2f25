#pragma once

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/foundations/base/rational.h"

namespace geargraph {

/// The rates of all joints from some linear equations and the rates of the inputs, by elimination in
/// fractions; also for wrong equations of a learner. std::nullopt if the equations do not determine the
/// rates.
/// Cost: cubic in the unknowns.
/// @pre rows of one length
[[nodiscard]] std::optional<std::vector<Rational>> ratesFrom(
    std::vector<std::vector<Rational>> rows, std::span<const std::pair<int, Rational>> inputs);

}  // namespace geargraph
