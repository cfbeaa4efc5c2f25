#pragma once

#include "core/presentation/pages/flow.h"

namespace geargraph::inline pages {

/// Breaks sentences into lines no wider than `width`, which start at x. A word that is wider than a line is
/// broken itself.
[[nodiscard]] std::vector<FlowLine> paragraphLines(const SetReport& report, const ReportWords& words,
                                                   const WordLook& look, const FlowLook& flow,
                                                   const WordMeasure& measure, double x, double width);

/// From baseline to baseline, for the size of the em.
constexpr double kLeading = 1.4;
constexpr double kAscent = 1.0;  ///< of a line above its baseline

}  // namespace geargraph::inline pages
