#pragma once

#include <optional>
#include <span>

#include "core/machine/train/train.h"
#include "core/mechanism/placement/placement.h"
#include "core/presentation/scene3d/stage.h"

namespace geargraph {

/// The train of a stage, with the instances of its parts.
struct StagedTrain {
  const Mechanism& mechanism;
  const Placement& placement;
  const GearTrain& train;
  std::span<const std::optional<std::size_t>> instanceOfGear;
  std::span<const int> linkOfInstance;
};

/// Adds the geometry other than solids: the operating pitch circles and cones (through the pitch points, so
/// they include profile shifts), the pitch points, the axes of the turning joints, and the labels of joints
/// and axes.
/// Cost: O(instances + joints + meshes). @pre the placement has a tree
void addMarks(MechanismScene& stage, const StagedTrain& staged);

}  // namespace geargraph
