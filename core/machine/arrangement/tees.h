#pragma once

#include "core/machine/arrangement/plan_draft.h"

namespace geargraph::inline arrangement {

/// Where axes meet, the link's own shaft can end in an eye about the shaft that passes the crossing or begins
/// there. Whatever else turns there on the link runs on the shaft that it encloses. False: it cannot.
bool placeTee(PlanDraft& draft, int link, int home, int axisClass);

/// The shafts of tees end in the walls of their eyes: not nearer than their edge may come to what turns
/// there. @pre shafts are nested
void trimTees(PlanDraft& draft);

}  // namespace geargraph::inline arrangement
