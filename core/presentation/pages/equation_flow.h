#pragma once

#include "core/presentation/pages/flow.h"

namespace geargraph::inline pages {

[[nodiscard]] std::vector<SetReport::SetLine> sharedLines(std::vector<FormulaLine> lines);

/// An equation on lines of its own, in the middle, with its number at the right margin.
[[nodiscard]] std::vector<FlowLine> equationLines(const SetReport::SetEquation& set,
                                                  const ReportEquation& equation, const FlowLook& flow,
                                                  const WordMeasure& measure);

}  // namespace geargraph::inline pages
