#pragma once

#include <string>

#include "core/theory/analysis/analysis.h"

namespace geargraph {

/// The mechanism with its engaged couplings as a Modelica model (Modelica.Mechanics.Rotational): a flange for
/// each turning joint, whose angle is that of the joint's head relative to its tail, measured from the drawn
/// pose; an equation with integer coefficients for each independent mesh or engaged coupling; lossless
/// torques. Ideal and massless. The equations hold in every pose because they are linear in the joint angles.
///
/// There are r + t equations for r multipliers and t flanges, so the model is balanced.
/// Cost: O(t + length of all cycles). @pre the snapshot has no errors, and kinematics with a matroid part
[[nodiscard]] std::string modelicaText(const AnalysisSnapshot& snapshot);

/// A Modelica class name from a document's name: ASCII letters, digits and _, starting with a capital letter.
[[nodiscard]] std::string modelicaName(std::string_view name);

}  // namespace geargraph
