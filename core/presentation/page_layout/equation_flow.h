#pragma once

#include "core/presentation/page_layout/flow.h"

namespace geargraph {

/// The lines with shared ownership of their boxes.
[[nodiscard]] std::vector<SetReport::SetLine> sharedLines(std::vector<FormulaLine> lines);

/// A displayed equation, centred, with its number at the right margin.
[[nodiscard]] std::vector<FlowLine> equationLines(const SetReport::SetEquation& set,
                                                  const ReportEquation& equation, const FlowParameters& flow,
                                                  const WordMeasure& measure);

}  // namespace geargraph
