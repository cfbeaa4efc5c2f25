#pragma once

#include <optional>

#include "core/machine/arrangement/plan_draft.h"

namespace geargraph::inline arrangement {

// Bearings on axes that cross their holder's.

/// A pin that a link holds out from its own shaft along the axis that meets its own, for wheels that all
/// stand on one side; none where wheels or shafts of other links are in the way.
[[nodiscard]] std::optional<PinPlan> pinFor(const PlanDraft& draft, int link, int home,
                                            const Bearing& bearing);

/// Bearing and arm for an axis that crosses the link's own. Bearings go where they are drawn if that is free,
/// arms beside the link's own wheel or where it has one already; but first of all where they pass the gears.
/// Where none does, a pin may, or an arm round the wheels.
void placeCrossing(PlanDraft& draft, int link, int home, Bearing& bearing);

}  // namespace geargraph::inline arrangement
