#pragma once

#include <optional>
#include <span>

#include "core/machine/train/train.h"
#include "core/mechanism/placement/placement.h"
#include "core/presentation/stage/stage.h"

namespace geargraph::inline train_stage {

/// The train that a stage was made of, and where its parts went.
struct StagedTrain {
  const Mechanism& mechanism;
  const Placement& placement;
  const GearTrain& train;
  std::span<const std::optional<std::size_t>> instanceOfGear;
  std::span<const int> linkOfInstance;
};

/// Adds what the geometry holds beside solids: the circles and cones that wheels roll on (through the pitch
/// points, so profile shifts are in them), the pitch points, the axes of the turning joints, and the labels
/// of joints and axes.
/// Cost: O(instances + joints + meshes). @pre the placement has a tree
void addMarks(Stage& stage, const StagedTrain& staged);

}  // namespace geargraph::inline train_stage
