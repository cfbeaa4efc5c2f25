#include "core/theory/pose/joint_limits.h"

#include <algorithm>
#include <numbers>

#include "core/foundations/base/contract.h"

namespace geargraph {

std::vector<AngleLimits> angleLimits(const Mechanism& mechanism) {
  constexpr double kDegree = std::numbers::pi / 180;
  std::vector<AngleLimits> limits(mechanism.turningJoints.size());
  for (std::size_t joint = 0; joint < limits.size(); ++joint) {
    const JointLimits& given = mechanism.turningJoints[joint].limits;
    const double unit = slides(mechanism.turningJoints[joint]) ? 1 : kDegree;
    if (given.low) limits[joint].low = given.low->value() * unit;
    if (given.high) limits[joint].high = given.high->value() * unit;
  }
  return limits;
}

MotionRange motionRange(std::span<const AngleLimits> limits, std::span<const double> start,
                        std::span<const double> rates) {
  GEARGRAPH_REQUIRE(limits.size() == start.size() && limits.size() == rates.size());
  MotionRange range;
  for (std::size_t joint = 0; joint < limits.size(); ++joint) {
    const double rate = rates[joint];
    if (rate == 0) continue;
    const double atLow = (limits[joint].low - start[joint]) / rate;
    const double atHigh = (limits[joint].high - start[joint]) / rate;
    const auto [from, to] = std::minmax(atLow, atHigh);
    if (to < range.to) {
      range.to = to;
      range.toJoint = static_cast<int>(joint);
    }
    if (from > range.from) {
      range.from = from;
      range.fromJoint = static_cast<int>(joint);
    }
  }
  return range;
}

std::vector<int> jointsBeyondLimits(std::span<const AngleLimits> limits, std::span<const double> angles) {
  GEARGRAPH_REQUIRE(limits.size() == angles.size());
  constexpr double kRounding = 1e-9;
  std::vector<int> beyond;
  for (std::size_t joint = 0; joint < limits.size(); ++joint) {
    if (angles[joint] < limits[joint].low - kRounding || angles[joint] > limits[joint].high + kRounding)
      beyond.push_back(static_cast<int>(joint));
  }
  return beyond;
}

}  // namespace geargraph
