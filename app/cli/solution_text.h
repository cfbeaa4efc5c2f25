#pragma once

#include <string>

#include "core/theory/analysis/analysis.h"

namespace geargraph::cli {

/// What the analysis says about motion, for a person at a terminal: rank and freedom, carriers, and the
/// solution as a table of outputs over inputs; empty where nothing of it is defined.
[[nodiscard]] std::string motionText(const AnalysisSnapshot& snapshot);

}  // namespace geargraph::cli
