#pragma once

#include "core/machine/body_layout/plan_draft.h"

namespace geargraph {

/// Adds the shaft of a link on an axis: it extends over the link's wheels, its bearing, its arms and
/// ring-gear carriers there. Radii are set later (nested_shafts.h). A wheel of the frame that none of its
/// bearings supports gets a pedestal (PedestalPlan).
void addShaft(PlanDraft& draft, AxisGroupOrdinal axisGroup, LinkOrdinal link);

/// Supports the wheels that are on an axis without turning about it by the bearings that their link has
/// there, ring gears by the tube between their disc and these.
void addFixedHubs(PlanDraft& draft);

}  // namespace geargraph
