#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/machine/body_layout/arrangement.h"

namespace geargraph {

/// Plans the frame: joins the ground's bearings, shafts and ring gears into one body on a base plate; z is
/// up.
///
/// 1. Bearings of one axis with nothing but shafts between them share a housing.
/// 2. Every part that is still separate gets a bracket of one or two straight bars: straight down to the
///    base; or outward at right angles to the axis, then down to the base or onto the rim of a ring gear of
///    the ground. The shortest one that is clear of the swept envelopes (swept_envelope.h) and of cases
///    (carrier_cases.h) is taken; long bars are thicker if still clear then.
/// 3. The feet are on one plate, below everything that moves. If all parts are connected without it, there is
///    no base.
///
/// Guaranteed: bars, housings and plate are clear of the swept envelopes. Not guaranteed: one connected body;
/// a bearing that envelopes enclose on all sides, or that could only be reached by more than two bars, stays
/// separate on a pedestal of its own (FramePlan::onPedestals). Deterministic. Cost: O(bearings * directions *
/// places * envelopes), some 0.1 ms for ten links.
[[nodiscard]] FramePlan planFrame(const Arrangement& plan, const GearTrain& train,
                                  const Placement& placement);

}  // namespace geargraph
