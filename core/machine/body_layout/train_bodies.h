#pragma once

#include <stop_token>

#include "core/machine/body_layout/arrangement.h"
#include "core/machine/body_layout/body_recipe.h"
#include "core/machine/train/train.h"
#include "core/mechanism/placement/placement.h"

namespace geargraph {

/// Adds shafts, arms, bearings and ring-gear carriers of every link, and sets the bores of its gears; their
/// solids are made on demand. Returns the arrangement. Incomplete if `stop` was requested meanwhile. Cost:
/// arrangementOf().
Arrangement addBodies(const Mechanism& mechanism, const Placement& placement, GearTrain& train,
                      const std::stop_token& stop = {});

/// `interference` for bodies without clearance from each other (GearTrain::blocked).
[[nodiscard]] Diagnostics bodyDiagnostics(const Mechanism& mechanism, const GearTrain& train);

/// The body of a link. @pre the recipe has at least one part
[[nodiscard]] LinkBody bodyOf(LinkOrdinal link, BodyRecipe recipe);

}  // namespace geargraph
