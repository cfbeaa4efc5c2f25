#pragma once

#include <QString>

#include "core/theory/analysis/analysis.h"

namespace geargraph::inline models {

/// What the degrees of freedom are, in sentences: what each input commands, which joints turn together at
/// fixed ratios, which never turn. Empty where nothing is solved.
[[nodiscard]] QString freedomText(const AnalysisSnapshot& snapshot);

}  // namespace geargraph::inline models
