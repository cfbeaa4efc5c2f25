#pragma once

#include "core/presentation/page_layout/flow.h"

namespace geargraph {

/// Breaks sentences into lines at most `width` wide, which start at x. A word wider than a line is broken.
[[nodiscard]] std::vector<FlowLine> paragraphLines(const SetReport& report, const ReportWords& words,
                                                   const TextStyle& style, const FlowParameters& flow,
                                                   const WordMeasure& measure, double x, double width);

/// The distance from baseline to baseline, in em.
constexpr double kLeading = 1.4;
constexpr double kAscent = 1.0;  ///< of a line above its baseline, in em

}  // namespace geargraph
