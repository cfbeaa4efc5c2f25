#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/theory/dynamics/simulation.h"

namespace geargraph {

/// The columns of a simulated motion as a table: "time", then for each input its angle, speed, acceleration
/// and torque, "angle 8", then "kinetic", "potential" and "work". s, rad, N m, J. `inputs`: their labels.
[[nodiscard]] std::vector<std::string> motionColumns(std::span<const std::string> inputs);
/// A sample as a row under motionColumns().
[[nodiscard]] std::vector<double> motionRow(const MotionSample& sample);

/// "complete", "limit", "massless", "unbounded", "stopped".
[[nodiscard]] std::string_view endName(SimulationEnd end);
/// Why a motion ends before its time, as a sentence; empty where it does not, or was stopped. `limitJoint`:
/// the label of Simulation::limitJoint.
[[nodiscard]] std::string endSentence(SimulationEnd end, std::string_view limitJoint);

/// The largest excess, over all samples, of the growth of kinetic and potential energy over the work done, J:
/// 0 but for the tolerance of the integration.
[[nodiscard]] double energyDefect(const Simulation& simulation);

}  // namespace geargraph
