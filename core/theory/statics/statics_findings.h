#pragma once

#include "core/foundations/base/diagnostic.h"
#include "core/theory/statics/statics_report.h"

namespace geargraph::inline statics {

// The findings of statics, a function each. The table of codes is in resources/schema/README.md.

[[nodiscard]] Diagnostic noLoad();
[[nodiscard]] Diagnostic unitLoad(const Mechanism& mechanism, const ShiftState& state);
[[nodiscard]] Diagnostic unknownUnit(const Mechanism& mechanism, bool leavesForcesOut);
[[nodiscard]] Diagnostic noMotion();
[[nodiscard]] Diagnostic noEfficiency();
/// The motion that nothing holds, the loads that drive it, and where a balance would hold it.
[[nodiscard]] Diagnostic unbalancedLoads(const Mechanism& mechanism, const StaticsReport& report);
/// Who shares loads, and whether torques outside are determined.
[[nodiscard]] Diagnostic sharedLoads(const Mechanism& mechanism, const KinematicModel& model,
                                     const StaticsSolution& solution);
/// A load in a joint that cannot turn, and the meshes that carry it.
[[nodiscard]] Diagnostic deadLoad(const Mechanism& mechanism, int joint, const std::vector<int>& meshes);
/// `backward`: only the reversed direction locks; `part`: of the losses, from which on it does.
[[nodiscard]] Diagnostic selfLocking(const Mechanism& mechanism, const StaticsReport& report,
                                     const std::vector<MeshEfficiency>& efficiencies,
                                     const std::optional<double>& part);
[[nodiscard]] Diagnostic patternLimit(const Mechanism& mechanism, const std::vector<int>& meshes);
/// A mesh that passes more than the power fed, seen from its carrier.
/// Meshes that pass more than the power fed: one finding for those that hang together by their gears.
/// `times` by mesh: what it passes over the power fed; 0 where nothing is to be said.
[[nodiscard]] Diagnostics recirculations(const Mechanism& mechanism, const std::vector<double>& times);
/// Power in a loop, as a part of the power fed.
[[nodiscard]] Diagnostic circulatingPower(const Mechanism& mechanism, const Circulation& circulation,
                                          double part);

}  // namespace geargraph::inline statics
