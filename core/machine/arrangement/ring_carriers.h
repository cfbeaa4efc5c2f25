#pragma once

#include "core/machine/arrangement/plan_draft.h"

namespace geargraph::inline arrangement {

/// Closes one face of each ring gear with a plate that stands on its link's shaft: the face on the bearing
/// side, so that carriers find the other one free, unless the link's other wheels call for the other face, or
/// the plate would cut through planets. Rings on axes with a plan of their own (coaxial_plan.h) are left out.
/// Cost: O(rings * gears).
void placeRingCarriers(PlanDraft& draft);

}  // namespace geargraph::inline arrangement
