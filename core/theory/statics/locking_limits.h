#pragma once

#include "core/theory/statics/efficiency_curve.h"

namespace geargraph::inline statics {

/// The efficiency of a mesh, the same in all of them, below which the train locks itself; none: at no
/// efficiency that was tried (0.01 to 1).
struct LockingLimits {
  std::optional<double> forward;   ///< no torque of the balances moves the loads
  std::optional<double> backward;  ///< all known torques reversed: the loads do not drive the train back
};

/// The greatest efficiencies at which it locks, within 1e-5. Nothing where `stop` was requested.
/// Cost: at most a hundred points of an efficiencyCurve(). @pre as efficiencyCurve() over meshEfficiency
[[nodiscard]] std::optional<LockingLimits> lockingLimits(
    const Mechanism& mechanism, const KinematicModel& model, const Placement& placement,
    const MatroidAnalysis& analysis, const StaticsReport& report, const StaticsOptions& options,
    const std::stop_token& stop = {});

}  // namespace geargraph::inline statics
