#pragma once

#include <vector>

#include "core/mechanism/placement/placement.h"
#include "core/theory/pose/forward_kinematics.h"

namespace geargraph {

/// The lines of all joints, by joint, in the reference pose; each points as the joint's own axis
/// does. Cost: O(t).
/// @pre the placement has a tree
[[nodiscard]] std::vector<TurningLine> turningLines(const Placement& placement);

}  // namespace geargraph
