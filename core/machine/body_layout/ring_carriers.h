#pragma once

#include "core/machine/body_layout/plan_draft.h"

namespace geargraph {

/// Closes one face of each ring gear with a disc on its link's shaft: the face on the bearing side, so that
/// the other one is free for carriers, unless the link's other wheels need the other face, or the disc would
/// cut through planets. Rings on axes with a coaxial plan (coaxial_plan.h) are left out.
/// Cost: O(rings * gears).
void placeRingCarriers(PlanDraft& draft);

}  // namespace geargraph
