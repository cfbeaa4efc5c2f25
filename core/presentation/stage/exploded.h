#pragma once

#include <stop_token>
#include <vector>

#include "core/presentation/stage/stage.h"

namespace geargraph::inline stage {

/// How far every instance moves, along the axis that its link turns about, when the train is pulled apart: mm
/// in the world of the scene's own poses, by instance. Links on parallel axes line up in the order in which
/// they lie, those in one plane by their size, until none of them overlaps another along that direction;
/// equal planets stay together. The ground stays.
///
/// Identity: all are 0 where the stage does not move. Incomplete when `stop` was requested. Cost: O(instances
/// log instances), and for each direction of axes O(its links^2) where all differ.
[[nodiscard]] std::vector<Eigen::Vector3d> separations(const Stage& stage, const std::stop_token& stop = {});

/// The poses with a part (0..1) of the separations, turned along with the instances. Identity: at 0 nothing
/// changes, and no separations are looked at. @pre one pose and else one separation an instance
void pullApart(const Scene& scene, std::span<const Eigen::Vector3d> separations, double part,
               std::span<Pose> poses);

}  // namespace geargraph::inline stage
