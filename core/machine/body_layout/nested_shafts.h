#pragma once

#include "core/machine/body_layout/plan_draft.h"

namespace geargraph {

/// Gives the shafts of an axis their radii. Overlapping shafts are nested: innermost is the one whose wheels,
/// arms and ring-gear carriers the others would cut least, of several the longest. All shafts of an axis are
/// reduced together until they fit into the bores of their wheels. Cost: at most O(shafts^3).
void nestShafts(PlanDraft& draft, AxisGroupOrdinal axisGroup);

}  // namespace geargraph
