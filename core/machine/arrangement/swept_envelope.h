#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/machine/arrangement/body_hulls.h"

namespace geargraph::inline arrangement {

/// A hollow cylinder that holds a moving part in every pose of the train: what the part sweeps about an axis
/// of the ground.
struct SweptEnvelope {
  HullKind kind = HullKind::gear;
  int link = 0;
  int axisClass = 0;      ///< the axis of the ground
  bool isOnAxis = false;  ///< the part is itself placed on this axis
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();
  double low = 0, high = 0;     ///< along the axis from the point
  double inner = 0, outer = 0;  ///< radii

  /// Does a straight line from a to b come nearer to the envelope than `margin`?
  [[nodiscard]] bool isNear(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double margin) const;
  /// The least coordinate of the envelope along a unit vector.
  [[nodiscard]] double lowestAlong(const Eigen::Vector3d& up) const;
};

/// The envelopes of all gears and planned parts of links other than the ground. Exact for what turns about an
/// axis of the ground; what carriers carry is held by the cylinder that it sweeps about the carrier's axis,
/// and so on down to the ground, which is more than it needs. Cost: O(parts * depth).
[[nodiscard]] std::vector<SweptEnvelope> sweptEnvelopes(const Arrangement& plan, const GearTrain& train,
                                                        const Placement& placement);

}  // namespace geargraph::inline arrangement
