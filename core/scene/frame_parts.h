#pragma once

#include <span>
#include <vector>

#include "core/gears/solid.h"
#include "core/scene/geometry.h"
#include "core/scene/wheel_parts.h"

namespace geargraph {

/// What holds the wheels: everything of a link but its teeth, in the reference pose and the base frame.
struct LinkFrame {
  int link = 0;
  Solid solid;  ///< shafts and arms
};

/// A collar where a joint's bearing is; it stays with the link nearer the ground.
struct Collar {
  int link = 0;
  int joint = 0;
  Solid solid;
};

struct FrameParts {
  std::vector<LinkFrame> links;
  std::vector<Collar> collars;
  double shaftRadius = 1;                 ///< of the thinnest shafts, a length
  std::vector<double> wheelBoreRadius;    ///< by wheel: the shaft it sits on
  std::vector<Eigen::Vector3d> bearings;  ///< by joint, base frame
};

/// Shafts, arms and bearings that a train with these axes and wheels could be built with:
///
/// 1. On each axis, the link nearest the ground has the axle, over all wheels and bearings there; each other
/// link a
///    tube over its own. Longer ones are thinner, so that they pass through each other.
/// 2. A link reaches each further axis it carries from its own axis or from an arm it already has, whichever
/// is
///    nearer: by the axle itself where that leads there, else by a bar.
/// 3. The ground's axles stand on the floor: vertical ones reach down to it, others stand on posts.
///
/// Cost: O(links + joints + wheels), but for many axes on one link.
/// @pre the placement has a tree
[[nodiscard]] FrameParts frameParts(const Mechanism& mechanism, const Placement& placement,
                                    std::span<const WheelPart> wheels);

}  // namespace geargraph
