#pragma once

#include <vector>

#include "core/gears/gear_spec.h"
#include "core/scene/geometry.h"

namespace geargraph {

/// A toothed wheel of a link, in the reference pose.
struct WheelPart {
  int link = 0;
  int axisClass = 0;
  std::vector<int> meshes;  ///< that it takes part in
  GearSpec spec;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  ///< the gear's own frame to the base frame
  double from = 0;                                         ///< its faces, along the class's line
  double to = 0;

  /// Middle of the teeth's face, in the gear's frame.
  [[nodiscard]] Eigen::Vector3d middle() const;
};

/// The wheels of all meshes that have a geometry. Meshes on the same link, axis, teeth, module and place
/// share one. Teeth are not put in phase yet. Cost: O(meshes), but for many wheels on one link.
[[nodiscard]] std::vector<WheelPart> wheelParts(const Mechanism& mechanism, const Placement& placement);

}  // namespace geargraph
