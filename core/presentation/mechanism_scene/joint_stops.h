#pragma once

#include "core/mechanism/model/mechanism.h"
#include "core/presentation/mechanism_scene/joint_motion.h"
#include "core/presentation/scene3d/stage.h"

namespace geargraph {

/// Sets `range` and `beyondLimits` of a stage with this motion, if joints of the mechanism have limits.
void addJointStops(MechanismScene& stage, const Mechanism& mechanism, const JointMotion& motion);

}  // namespace geargraph
