#pragma once

#include <string>

#include "core/theory/analysis/analysis.h"
#include "core/theory/statics/statics_report.h"

namespace geargraph::cli {

/// The torques, forces and powers as text for a terminal. `state`: index, -1: none.
[[nodiscard]] std::string staticsText(const AnalysisSnapshot& snapshot, const StaticsReport& report,
                                      int state);

}  // namespace geargraph::cli
