#pragma once

#include "core/teaching/force_tables/force_table.h"
#include "core/theory/statics/efficiency_curve.h"

namespace geargraph {

/// The title of the curve's variable: "speed of joint 6 / joint 5", "efficiency of every mesh".
[[nodiscard]] std::string axisTitle(const Mechanism& mechanism, const EfficiencyCurve& curve);
/// The title of a balance of the curve: "joint 6", "link 3"; `held` is one of EfficiencyCurve::held.
[[nodiscard]] std::string heldTitle(const Mechanism& mechanism, const StaticsReport& report, int held);

/// The curve as a table: one row per point with the variable, efficiency forward and backward, and the
/// torques of the balances. Cells are empty if the train is self-locking or no power is fed.
[[nodiscard]] ValueTable efficiencyTable(const Mechanism& mechanism, const StaticsReport& report,
                                         const EfficiencyCurve& curve);

}  // namespace geargraph
