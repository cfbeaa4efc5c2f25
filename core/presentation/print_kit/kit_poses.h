#pragma once

#include <span>
#include <vector>

#include "core/foundations/base/rational.h"
#include "core/presentation/print_kit/print_kit.h"
#include "core/theory/pose/forward_kinematics.h"

namespace geargraph {

/// Poses spread over one turn of each joint that turns, in each motion, within the limits of joints:
/// 8 to 24 for each different speed. `motions`: rates of all joints, rad/s.
[[nodiscard]] std::vector<KitPose> kitPoses(const Mechanism& mechanism, const ForwardKinematics& kinematics,
                                            std::span<const std::vector<Rational>> motions);

}  // namespace geargraph
