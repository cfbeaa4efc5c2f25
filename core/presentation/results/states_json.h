#pragma once

#include <string>

#include "core/theory/analysis/analysis.h"

namespace geargraph::inline results {

/// The shift table as JSON (`states --json`): "states" is null where the mechanism leaves them undefined.
/// `snapshot`: after analyzeStates(); null where the file could not be read.
[[nodiscard]] std::string statesJson(const AnalysisSnapshot* snapshot);

}  // namespace geargraph::inline results
