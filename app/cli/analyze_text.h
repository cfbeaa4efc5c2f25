#pragma once

#include <string>

#include "core/theory/analysis/analysis.h"

namespace geargraph::cli {

/// The analysis for a person at a terminal: counts, elements with their labels, and the matrices as the paper
/// prints them; a matrix too wide or high for a screen is only described.
[[nodiscard]] std::string analysisText(const AnalysisSnapshot& snapshot);

}  // namespace geargraph::cli
