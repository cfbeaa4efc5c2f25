#pragma once

#include <stop_token>
#include <vector>

#include "core/presentation/scene3d/stage.h"

namespace geargraph {

/// The displacement of every instance in the exploded view, along the axis about which its link turns: mm, in
/// the world of the scene's own poses, by instance. Links on parallel axes are lined up in their order, those
/// in one plane by size, until none overlaps another along that direction; equal planets stay together. The
/// ground stays.
///
/// Identity: all are 0 for a stage that does not move. Incomplete if `stop` was requested. Cost: O(instances
/// log instances), and for each direction of axes O(its links^2) if all differ.
[[nodiscard]] std::vector<Eigen::Vector3d> explosionOffsets(const MechanismScene& stage,
                                                            const std::stop_token& stop = {});

/// Displaces the poses by a part (0..1) of the offsets, which turn with the instances. Identity: at 0
/// nothing changes, and no offsets are needed. @pre one pose and, unless part is 0, one offset per
/// instance
void explode(const Scene& scene, std::span<const Eigen::Vector3d> offsets, double part,
             std::span<Pose> poses);

}  // namespace geargraph
