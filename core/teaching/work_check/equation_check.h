#pragma once

#include "core/teaching/work_check/work_check.h"
#include "core/teaching/work_check/written_formula.h"

namespace geargraph {

/// Checks equations between velocities: each is right if it holds in every motion of the mechanism, with each
/// side expressed in the inputs by the exact solution. Decimals agree within their last place. Fails with
/// `syntax` at the place that cannot be parsed.
[[nodiscard]] Expected<std::vector<EquationVerdict>> checkEquations(
    const Vocabulary& vocabulary, const std::vector<WrittenEquation>& equations,
    const std::stop_token& stop = {});

}  // namespace geargraph
