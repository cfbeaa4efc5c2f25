#pragma once

#include "core/machine/body_layout/arrangement.h"
#include "core/machine/body_layout/complete_train.h"

namespace geargraph::test {

/// A mechanism's train with its arrangement.
struct PlannedTrain {
  explicit PlannedTrain(const Mechanism& mechanism)
      : placement(placementOf(mechanism)),
        train(trainOf(mechanism, placement)),
        plan(arrangementOf(mechanism, placement, train)) {}

  Placement placement;
  GearTrain train;
  Arrangement plan;
};

}  // namespace geargraph::test
