#pragma once

#include "core/machine/arrangement/plan_draft.h"

namespace geargraph::inline arrangement {

/// Bodies of trains that are too large to be routed: nothing is compared with anything beyond its own axis. A
/// straight arm from each carrier's axis to each bearing that it holds; the frame's stand on feet. Cost:
/// O(gears + joints), of each axis O(its shafts^2).
void planSimply(PlanDraft& draft);

}  // namespace geargraph::inline arrangement
