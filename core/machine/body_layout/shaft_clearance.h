#pragma once

#include <cstddef>

#include "core/machine/body_layout/plan_draft.h"

namespace geargraph {

// Where a shaft is accessible: past the wheels of its own axis and of others, and past arms.

/// The interval of the hubs of a link's wheels on the axis, without rings. Empty (low > high) if there are
/// none.
[[nodiscard]] Interval hubInterval(const PlanDraft& draft, AxisGroupOrdinal axisGroup, LinkOrdinal link);

/// The interval of what a link's shaft supports on the axis: wheels, and the discs of ring gears. Empty (low
/// > high) if there is nothing.
[[nodiscard]] Interval heldInterval(const PlanDraft& draft, AxisGroupOrdinal axisGroup, LinkOrdinal link);

/// Is the shaft of the bearing's link, from its wheels to the bearing at `at`, clear of the wheels on other
/// axes in every pose?
[[nodiscard]] bool shaftPasses(const PlanDraft& draft, const Bearing& bearing, double at);

/// The number of wheels of other links on the axis between a level and the link's own parts there, including
/// its bearing.
[[nodiscard]] std::ptrdiff_t enclosedBy(const PlanDraft& draft, LinkOrdinal link, AxisGroupOrdinal home,
                                        double level);

/// Has a carrier only its arm on its axis, and no path from there to its bearing past the parts of others?
[[nodiscard]] bool isTrapped(const PlanDraft& draft, LinkOrdinal link, AxisGroupOrdinal home, double level);

/// Does the shaft that a carrier holds collide with an arm of another link as it revolves?
[[nodiscard]] bool meetsArms(const PlanDraft& draft, const Bearing& bearing, double at);

/// Does a carrier's arm to an axis collide with a shaft of the frame as it revolves?
[[nodiscard]] bool sweepsShafts(const PlanDraft& draft, LinkOrdinal link, AxisGroupOrdinal home, double level,
                                AxisGroupOrdinal axisGroup);

}  // namespace geargraph
