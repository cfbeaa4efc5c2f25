#pragma once

#include <set>

#include "core/presentation/scene3d/input_trajectory.h"
#include "core/presentation/scene3d/motion_curves.h"
#include "ui/motion_panel/simulation_service.h"

namespace geargraph {

/// The plotted quantities of a simulated motion.
enum class MotionQuantity { speeds, torques, energies };

/// The quantity over time: speeds of the inputs and of the turning joints among `chosen`; torques of the
/// motors; or the energies, the work done, and the energy balance, which stays 0.
/// @pre the motion has samples and is the mechanism's
[[nodiscard]] CurveSheet motionSheet(const Mechanism& mechanism, const SimulatedMotion& motion,
                                     MotionQuantity quantity, const std::set<ElementId>& chosen = {});

/// The motion for the 3D view. @pre it has samples
[[nodiscard]] InputTrajectoryPtr trajectoryOf(const Simulation& simulation);

/// The motion as CSV: motionColumns() and one row per sample.
[[nodiscard]] std::string motionCsv(const Mechanism& mechanism, const SimulatedMotion& motion,
                                    char separator);

}  // namespace geargraph
