#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/machine/body_layout/body_hulls.h"

namespace geargraph {

/// The hollow cylinder about an axis of the ground that contains a moving part in every pose of the train.
struct SweptEnvelope {
  HullKind kind = HullKind::gear;
  LinkOrdinal link = 0;
  AxisGroupOrdinal axisGroup = 0;  ///< the axis of the ground
  bool isOnAxis = false;           ///< the part itself is placed on this axis
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();
  double low = 0, high = 0;     ///< along the axis from the point
  double inner = 0, outer = 0;  ///< radii

  /// Is the straight segment from a to b nearer to the envelope than `margin`?
  [[nodiscard]] bool isNear(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double margin) const;
  /// The least coordinate of the envelope along a unit vector.
  [[nodiscard]] double lowestAlong(const Eigen::Vector3d& up) const;
};

/// The envelopes of all gears and planned parts of links other than the ground. Exact for parts that turn
/// about an axis of the ground; a part on a carrier is bounded by the cylinder that it sweeps about the
/// carrier's axis, and so on down to the ground, which overestimates it. Cost: O(parts * depth).
[[nodiscard]] std::vector<SweptEnvelope> sweptEnvelopes(const Arrangement& plan, const GearTrain& train,
                                                        const Placement& placement);

}  // namespace geargraph
