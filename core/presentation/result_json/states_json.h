#pragma once

#include <span>
#include <string>

#include "core/theory/analysis/analysis.h"
#include "core/theory/statics/shift_statics.h"

namespace geargraph {

/// The shift table as JSON (`states --json`): "states" is null where the mechanism leaves them undefined.
/// `snapshot`: after analyzeStates(); null where the file could not be read. `torques`: as solvedShift(), or
/// empty.
[[nodiscard]] std::string statesJson(const AnalysisSnapshot* snapshot,
                                     std::span<const StateForces> torques = {});

}  // namespace geargraph
