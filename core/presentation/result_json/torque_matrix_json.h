#pragma once

#include <optional>
#include <span>

#include "core/foundations/files/json_writer.h"
#include "core/theory/statics/statics_report.h"

namespace geargraph {

/// A solution of statics: the torques in the balanced joints over those in the loaded ones, as fractions and
/// in the gear ratios. @pre both are of one report of the mechanism
void writeTorqueMatrixJson(JsonWriter& json, const Mechanism& mechanism, std::span<const int> balancedJoints,
                           const TorqueMatrix& matrix, const std::optional<SymbolicStatics>& symbolic);

}  // namespace geargraph
