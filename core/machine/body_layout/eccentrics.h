#pragma once

#include "core/machine/body_layout/plan_draft.h"

namespace geargraph {

/// Are two parallel axes so near to each other that no arm with a boss at either end fits between them, as
/// those of the crank and the disc of a cycloidal drive?
[[nodiscard]] bool isEccentric(const PlanDraft& draft, AxisGroupOrdinal home, AxisGroupOrdinal axisGroup);

/// Tries to hold the bearing's link on a crank: the link's own shaft ends in a round disc beside the wheels
/// of the child, on the side that the shaft comes from, and these turn on a pin on the disc. False: the link
/// has no bearing yet, the child has no wheels or is not alone on its axis, or something is in the way.
/// @pre isEccentric(draft, home, class of the bearing)
bool placeEccentric(PlanDraft& draft, LinkOrdinal link, AxisGroupOrdinal home, Bearing& bearing);

}  // namespace geargraph
