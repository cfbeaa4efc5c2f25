#pragma once

#include "core/mechanism/mechanism.h"
#include "core/render/stage.h"
#include "core/scene/joint_motion.h"

namespace geargraph {

/// Fills `range` and `beyondLimits` of a stage that moves so, where joints of the mechanism have limits.
void addJointStops(Stage& stage, const Mechanism& mechanism, const JointMotion& motion);

}  // namespace geargraph
