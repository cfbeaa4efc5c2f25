#pragma once

#include <string>

#include "core/theory/analysis/analysis.h"
#include "core/theory/statics/statics_report.h"

namespace geargraph::cli {

/// The torques, forces and powers for a person at a terminal. `state`: -1 for none.
[[nodiscard]] std::string staticsText(const AnalysisSnapshot& snapshot, const StaticsReport& report,
                                      int state);

}  // namespace geargraph::cli
