#pragma once

#include "core/machine/body_layout/plan_draft.h"

namespace geargraph {

/// Plans the bodies of trains that are too large for routing, without collision checks between axes: a
/// straight arm from each carrier's axis to each bearing that it holds; bearings of the frame on pedestals.
/// Cost: O(gears + joints), and O(shafts^2) per axis.
void planWithoutRouting(PlanDraft& draft);

}  // namespace geargraph
