#pragma once

#include "core/machine/body_layout/plan_draft.h"

namespace geargraph {

/// One try of arrangementOf(), on a new draft: first the axes with a coaxial plan (coaxial_plan.h), then
/// ring-gear carriers, then bearings and arms link by link from the ground outwards, then shafts. If `stop`
/// is requested it ends early and the draft is meaningless.
void planBodies(PlanDraft& draft);

}  // namespace geargraph
