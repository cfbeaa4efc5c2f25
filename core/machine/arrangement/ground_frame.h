#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/machine/arrangement/arrangement.h"

namespace geargraph::inline arrangement {

/// Joins the ground's bearings, shafts and rings into one body, upright on a base plate: z is up.
///
/// 1. Bearings of one axis with nothing but shafts between them share a housing.
/// 2. What is still separate gets a bracket of one or two straight bars: straight down to the base; or
///    outward at right angles to the axis, then down to the base or onto the rim of a ring of the ground.
///    The shortest that stays clear of the swept envelopes (swept_envelope.h) and of cases
///    (carrier_cases.h) is taken; long bars are thicker where they stay clear then, too.
/// 3. The feet stand on one plate, below everything that moves. Where everything hangs together without a
///    base there is none.
///
/// Always: bars, housings and plate stay clear of the swept envelopes. Wanted: one connected body. Not
/// guaranteed: a bearing that envelopes enclose on all sides, or whose free ways have more than two bars,
/// stays separate, on feet of its own (FramePlan::onFeet).
/// Deterministic. Cost: O(bearings * directions * places * envelopes), some 0.1 ms for ten links.
[[nodiscard]] FramePlan planFrame(const Arrangement& plan, const GearTrain& train,
                                  const Placement& placement);

}  // namespace geargraph::inline arrangement
