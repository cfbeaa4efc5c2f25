#pragma once

#include <optional>

#include "core/machine/body_layout/plan_draft.h"

namespace geargraph {

// Bearings of the frame on pedestals of their own.

/// The coordinate at which a bearing of the frame can have a pedestal of its own, beside the wheels that it
/// supports; std::nullopt if there is none.
[[nodiscard]] std::optional<double> pedestalPlace(const PlanDraft& draft, const Bearing& bearing);

/// Places the bearing there and occupies the slot on its axis.
void putOnPedestal(PlanDraft& draft, Bearing& bearing, double place);

/// The same at pedestalPlace(); if there is none, its links are reported as blocked.
void putOnPedestalOrReport(PlanDraft& draft, Bearing& bearing);

}  // namespace geargraph
