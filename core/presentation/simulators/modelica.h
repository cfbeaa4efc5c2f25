#pragma once

#include <string>

#include "core/theory/analysis/analysis.h"

namespace geargraph::inline simulators {

/// The mechanism as engaged as a model in Modelica (Modelica.Mechanics.Rotational): a flange for each turning
/// joint, whose angle is that of the joint's head relative to its tail, from the drawn pose; an equation for
/// each independent mesh or engaged coupling, in whole teeth; torques that lose no power. Ideal and massless.
/// The rows hold in every pose, for they are linear in the angles of the joints.
///
/// r + t equations for r multipliers and t flanges, so that the model is balanced.
/// Cost: O(t + length of all cycles). @pre the snapshot has no errors, and kinematics with a matroid part
[[nodiscard]] std::string modelicaText(const AnalysisSnapshot& snapshot);

/// A document's name as one of a Modelica class: ASCII letters, digits and _, the first a capital letter.
[[nodiscard]] std::string modelicaName(std::string_view name);

}  // namespace geargraph::inline simulators
