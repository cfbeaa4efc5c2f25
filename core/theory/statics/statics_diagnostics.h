#pragma once

#include "core/foundations/base/diagnostic.h"
#include "core/theory/statics/statics_report.h"

namespace geargraph {

// The diagnostics of statics, one function per code. The table of codes is in resources/schema/README.md.

[[nodiscard]] Diagnostic noLoad();
[[nodiscard]] Diagnostic unitLoad(const Mechanism& mechanism, const ShiftState& state);
[[nodiscard]] Diagnostic unknownUnit(const Mechanism& mechanism, bool leavesForcesOut);
/// `withoutLosses`: losses were asked for, so that torques are left out, too.
[[nodiscard]] Diagnostic noMotion(bool withoutLosses);
/// Losses were asked for, and nothing moves: there are none.
[[nodiscard]] Diagnostic noLossesAtRest();
[[nodiscard]] Diagnostic noEfficiency();
/// The motion that nothing holds, the loads that drive it, and where a balance would hold it.
[[nodiscard]] Diagnostic unbalancedLoads(const Mechanism& mechanism, const StaticsReport& report);
/// Loads at these positions act where a balance holds: it cancels them.
[[nodiscard]] Diagnostic loadsOnBalances(const Mechanism& mechanism, const StaticsReport& report,
                                         const std::vector<std::size_t>& loads);
/// Names the meshes that share loads indeterminately, and whether the other torques are determined: with
/// losses by which assumption, and their range over all distributions.
[[nodiscard]] Diagnostic sharedLoads(const Mechanism& mechanism, const KinematicModel& model,
                                     const StaticsReport& report);
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

}  // namespace geargraph
