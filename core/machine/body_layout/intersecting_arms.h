#pragma once

#include <optional>

#include "core/machine/body_layout/plan_draft.h"

namespace geargraph {

// Bearings on axes that intersect the axis of the link that holds them.

/// A cantilevered pin from a link's own shaft along an intersecting axis, for wheels that are all on one
/// side; std::nullopt if it would collide with wheels or shafts of other links.
[[nodiscard]] std::optional<PinPlan> pinFor(const PlanDraft& draft, LinkOrdinal link, AxisGroupOrdinal home,
                                            const Bearing& bearing);

/// Places bearing and arm for an axis that intersects the link's own. First criterion: clear of the gears;
/// then forks, from one bar to bearings on both sides of the link's axis; then bearings as drawn, arms beside
/// the link's own wheel or at an arm that it has already. If no arm is clear of the gears, a pin is tried,
/// then an arm around the wheels.
void placeIntersecting(PlanDraft& draft, LinkOrdinal link, AxisGroupOrdinal home, Bearing& bearing);

}  // namespace geargraph
