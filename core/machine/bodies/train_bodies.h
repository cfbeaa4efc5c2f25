#pragma once

#include <stop_token>

#include "core/machine/arrangement/arrangement.h"
#include "core/machine/bodies/body_recipe.h"
#include "core/machine/train/train.h"
#include "core/mechanism/placement/placement.h"

namespace geargraph::inline bodies {

/// Adds shafts, arms, bearings and the cups of rings for every link, and bores its gears for the shafts;
/// their solids are made on demand. Returns the arrangement that they show. Adds none, or some, when `stop`
/// was requested meanwhile. Cost: arrangementOf().
Arrangement addBodies(const Mechanism& mechanism, const Placement& placement, GearTrain& train,
                      const std::stop_token& stop = {});

/// `interference` of bodies that have no clearance from each other (GearTrain::blocked).
[[nodiscard]] Diagnostics bodyDiagnostics(const Mechanism& mechanism, const GearTrain& train);

/// A link's body of these parts, one at least.
[[nodiscard]] LinkBody bodyOf(int link, BodyRecipe recipe);

}  // namespace geargraph::inline bodies
