#pragma once

#include <stop_token>

#include "core/machine/bodies/body_recipe.h"
#include "core/machine/train/train.h"
#include "core/mechanism/placement/placement.h"

namespace geargraph::inline bodies {

/// Adds shafts, arms, bearings and the cups of rings for every link, and bores its gears for the shafts.
/// What finds no way past others is an `interference` of the train. `cache`: keeps solids from one edit to
/// the next. Adds none, or some, when `stop` was requested meanwhile.
void addBodies(const Mechanism& mechanism, const Placement& placement, GearTrain& train,
               BodyCache* cache = nullptr, const std::stop_token& stop = {});

/// The findings of addBodies() alone: bodies are planned but not made. Of no use when `stop` was requested
/// meanwhile. Cost: planBodies().
[[nodiscard]] Diagnostics bodyDiagnostics(const Mechanism& mechanism, const Placement& placement,
                                          const GearTrain& train, const std::stop_token& stop);

}  // namespace geargraph::inline bodies
