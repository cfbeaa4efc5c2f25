#pragma once

#include "core/machine/arrangement/plan_draft.h"

namespace geargraph::inline arrangement {

/// Gives the shafts of an axis their radii. Shafts that lie over each other are nested: inmost comes the one
/// of whose wheels, arms and ring carriers the others would cut through the least, of several the longest.
/// All of an axis shrink together until the bores of their wheels hold them. Cost: O(shafts^3) at most.
void nestShafts(PlanDraft& draft, int axisClass);

}  // namespace geargraph::inline arrangement
