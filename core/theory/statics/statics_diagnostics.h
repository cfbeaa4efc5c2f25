#pragma once

#include "core/foundations/base/diagnostic.h"
#include "core/theory/statics/statics_report.h"

namespace geargraph::inline statics {

// The diagnostics of statics, one function per code. The table of codes is in resources/schema/README.md.

[[nodiscard]] Diagnostic noLoad();
[[nodiscard]] Diagnostic unitLoad(const Mechanism& mechanism, const ShiftState& state);
[[nodiscard]] Diagnostic unknownUnit(const Mechanism& mechanism, bool leavesForcesOut);
[[nodiscard]] Diagnostic noMotion();
[[nodiscard]] Diagnostic noEfficiency();
/// The motion that nothing holds, the loads that drive it, and where a balance would hold it.
[[nodiscard]] Diagnostic unbalancedLoads(const Mechanism& mechanism, const StaticsReport& report);
/// Names the meshes that share loads indeterminately, and whether the other torques are determined.
[[nodiscard]] Diagnostic sharedLoads(const Mechanism& mechanism, const KinematicModel& model,
                                     const StaticsSolution& solution);
/// A load in a joint that cannot turn, and the meshes that carry it.
[[nodiscard]] Diagnostic deadLoad(const Mechanism& mechanism, JointOrdinal joint,
                                  const std::vector<int>& meshes);
/// Self-locking forward or, where only the report's reversed solution locks, backward. `part`: the fraction
/// of the losses from which on it locks (selfLockingPart()).
[[nodiscard]] Diagnostic selfLocking(const Mechanism& mechanism, const StaticsReport& report,
                                     const std::vector<MeshEfficiency>& efficiencies,
                                     const std::optional<double>& part);
[[nodiscard]] Diagnostic patternLimit(const Mechanism& mechanism, const std::vector<int>& meshes);
/// Meshes that transmit more than the power fed, seen from their carriers: one diagnostic for each group
/// connected by gears. `times` by mesh: its power over the power fed; 0: not reported.
[[nodiscard]] Diagnostics recirculations(const Mechanism& mechanism, const std::vector<double>& times);
/// `part`: the power in the loop over the power fed.
[[nodiscard]] Diagnostic circulatingPower(const Mechanism& mechanism, const Circulation& circulation,
                                          double part);

}  // namespace geargraph::inline statics
