#pragma once

#include "core/machine/arrangement/plan_draft.h"

namespace geargraph::inline arrangement {

/// Adds the shaft of a link on an axis: it reaches from the link's wheels to its bearing, its arms and ring
/// carriers there. No radius yet (nested_shafts.h). A wheel of the frame that none of its bearings reaches
/// stands on a stub.
void addShaft(PlanDraft& draft, int axisClass, int link);

/// Wheels that stand on an axis without turning about it are held by the bearings that their link has there,
/// rings by the tube between their plate and these.
void addFixedHubs(PlanDraft& draft);

}  // namespace geargraph::inline arrangement
