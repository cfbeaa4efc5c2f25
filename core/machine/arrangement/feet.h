#pragma once

#include <optional>

#include "core/machine/arrangement/plan_draft.h"

namespace geargraph::inline arrangement {

// Bearings of the frame on feet of their own.

/// Where a bearing of the frame can stand on feet of its own, beside the wheels that it holds; nothing: there
/// is no place.
[[nodiscard]] std::optional<double> placeOfFeet(const PlanDraft& draft, const Bearing& bearing);

/// Places it there and takes the place on its axis.
void putOnFeet(PlanDraft& draft, Bearing& bearing, double place);

/// The same at the best place; where there is none it is blocked.
void putOnFeetOrReport(PlanDraft& draft, Bearing& bearing);

}  // namespace geargraph::inline arrangement
