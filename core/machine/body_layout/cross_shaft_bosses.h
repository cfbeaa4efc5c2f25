#pragma once

#include "core/machine/body_layout/plan_draft.h"

namespace geargraph {

/// Tries to end the link's own shaft in a cross-shaft boss (CrossShaftBossPlan) around the shaft of an
/// intersecting axis that passes the intersection or begins there. Other links that turn there on the same
/// link run on the shaft inside them. False: not possible.
bool placeCrossShaftBoss(PlanDraft& draft, LinkOrdinal link, AxisGroupOrdinal home,
                         AxisGroupOrdinal axisGroup);

/// Ends the shafts of cross-shaft bosses within the walls of the bosses, so that their edges stay clear of
/// the shaft in the boss. @pre shafts are nested
void trimCrossShaftBosses(PlanDraft& draft);

}  // namespace geargraph
