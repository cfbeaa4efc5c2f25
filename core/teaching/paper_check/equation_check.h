#pragma once

#include "core/teaching/paper_check/paper_check.h"
#include "core/teaching/paper_check/written_formula.h"

namespace geargraph::inline paper_check {

/// Each equation between velocities holds if it is true in every motion of the mechanism: each side as a sum
/// over the inputs, by the exact solution. Decimals agree within their last place.
/// Errors: `syntax` with the place of what cannot be read.
[[nodiscard]] Expected<std::vector<EquationVerdict>> checkEquations(
    const Vocabulary& vocabulary, const std::vector<WrittenEquation>& equations,
    const std::stop_token& stop = {});

}  // namespace geargraph::inline paper_check
