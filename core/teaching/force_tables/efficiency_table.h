#pragma once

#include "core/teaching/force_tables/force_table.h"
#include "core/theory/statics/efficiency_curve.h"

namespace geargraph::inline force_tables {

/// What a curve is followed over: "speed of joint 6 / joint 5", "efficiency of every mesh".
[[nodiscard]] std::string axisTitle(const Mechanism& mechanism, const EfficiencyCurve& curve);
/// What a balance of the curve acts on: "joint 6", "link 3"; `held` is one of EfficiencyCurve::held.
[[nodiscard]] std::string heldTitle(const Mechanism& mechanism, const StaticsReport& report, int held);

/// The curve: a row for each of its points; its place, efficiency forward and backward, the torques of the
/// balances. Cells are empty where the train locks itself or nothing is fed.
[[nodiscard]] ValueTable efficiencyTable(const Mechanism& mechanism, const StaticsReport& report,
                                         const EfficiencyCurve& curve);

}  // namespace geargraph::inline force_tables
