#pragma once

#include <limits>
#include <span>
#include <vector>

#include "core/mechanism/model/mechanism.h"

namespace geargraph {

/// How far a joint may turn from the reference pose, rad, or slide, in the document's unit; infinite where an
/// end is open.
struct AngleLimits {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
};

/// The limits of all joints, by joint. Cost: O(t).
[[nodiscard]] std::vector<AngleLimits> angleLimits(const Mechanism& mechanism);

/// The interval of time, s, in which all joints stay within their limits when each turns at a constant rate;
/// infinite where nothing limits it. `from` <= 0 <= `to` where the angles at time 0 are within the limits;
/// `from` > `to` where there is no such time.
struct MotionRange {
  double from = -std::numeric_limits<double>::infinity();
  double to = std::numeric_limits<double>::infinity();
  JointOrdinal fromJoint = -1;  ///< the joint that reaches its limit then; -1: none
  JointOrdinal toJoint = -1;

  [[nodiscard]] bool isLimited() const { return fromJoint >= 0 || toJoint >= 0; }
};

/// For joints that are at `start` (rad) at time 0 and turn at `rates` (rad/s). Joints at rest limit nothing.
/// Cost: O(t).
/// @pre one of each per joint
[[nodiscard]] MotionRange motionRange(std::span<const AngleLimits> limits, std::span<const double> start,
                                      std::span<const double> rates);

/// Joints that are beyond their limits at these angles (rad), by more than rounding.
[[nodiscard]] std::vector<int> jointsBeyondLimits(std::span<const AngleLimits> limits,
                                                  std::span<const double> angles);

}  // namespace geargraph
