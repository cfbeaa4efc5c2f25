#pragma once

#include <cstddef>

#include "core/machine/arrangement/plan_draft.h"

namespace geargraph::inline arrangement {

// Where a shaft comes out: past the wheels of its own axis and of others, and past arms.

/// The hubs of a link's wheels on the axis, but for rings. Empty (low > high) where there are none.
[[nodiscard]] Stretch hubStretch(const PlanDraft& draft, int axisClass, int link);

/// What a link's shaft holds on the axis: wheels, and the plates of rings, which are hollow. Empty where
/// there is nothing.
[[nodiscard]] Stretch heldStretch(const PlanDraft& draft, int axisClass, int link);

/// Does the shaft of the link that a bearing holds, from its wheels to there, stay clear of the wheels on
/// other axes, wherever their carriers take them?
[[nodiscard]] bool shaftPasses(const PlanDraft& draft, const Bearing& bearing, double at);

/// Wheels of others on the axis between a level and what the link has there, its bearing included.
[[nodiscard]] std::ptrdiff_t enclosedBy(const PlanDraft& draft, int link, int home, double level);

/// Has a carrier nothing but its arm on its axis, and no way from there to its bearing past what others have?
[[nodiscard]] bool isTrapped(const PlanDraft& draft, int link, int home, double level);

/// Does the shaft that a carrier holds go round through an arm of another link?
[[nodiscard]] bool meetsArms(const PlanDraft& draft, const Bearing& bearing, double at);

/// Does a carrier's arm to an axis go round through a shaft of the frame?
[[nodiscard]] bool sweepsShafts(const PlanDraft& draft, int link, int home, double level, int axisClass);

}  // namespace geargraph::inline arrangement
