#pragma once

#include <string>

#include "core/theory/analysis/analysis.h"

namespace geargraph::cli {

/// The kinematic results of the analysis as text for a terminal: rank and degrees of freedom, carriers, and
/// the solution as a table of outputs by inputs; empty if none of it is defined.
[[nodiscard]] std::string motionText(const AnalysisSnapshot& snapshot);

}  // namespace geargraph::cli
