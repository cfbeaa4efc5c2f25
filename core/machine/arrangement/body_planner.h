#pragma once

#include "core/machine/arrangement/plan_draft.h"

namespace geargraph::inline arrangement {

/// One try of arrangementOf(), on a new draft: axes with a plan of their own first, then ring carriers,
/// bearings and arms link by link from the ground outwards, shafts at last. Ends early, with a plan of no
/// use, when `stop` was requested.
void planBodies(PlanDraft& draft);

}  // namespace geargraph::inline arrangement
