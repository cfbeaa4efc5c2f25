#pragma once

#include "core/mechanism/model/mechanism.h"
#include "core/presentation/stage/stage.h"
#include "core/presentation/train_stage/joint_motion.h"

namespace geargraph::inline train_stage {

/// Sets `range` and `beyondLimits` of a stage with this motion, if joints of the mechanism have limits.
void addJointStops(Stage& stage, const Mechanism& mechanism, const JointMotion& motion);

}  // namespace geargraph::inline train_stage
