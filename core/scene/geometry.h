#pragma once

#include <Eigen/Geometry>

#include "core/placement/placement.h"

namespace geargraph {

[[nodiscard]] inline Eigen::Vector3d vectorOf(const Vector3& v) {
  return {v[0], v[1], v[2]};
}

/// A line of an axis class, as Eigen has it; places on it are told by their distance from `point`, along.
struct ClassLine {
  Eigen::Vector3d point;
  Eigen::Vector3d direction;  ///< length 1

  [[nodiscard]] double along(const Eigen::Vector3d& place) const { return (place - point).dot(direction); }
  [[nodiscard]] Eigen::Vector3d at(double along) const { return point + along * direction; }
  [[nodiscard]] Eigen::Vector3d foot(const Eigen::Vector3d& place) const { return at(along(place)); }
};

[[nodiscard]] inline ClassLine lineOf(const Placement& placement, int axisClass) {
  const AxisLine& line = placement.lineOfClass(axisClass);
  return {vectorOf(line.point), vectorOf(line.direction)};
}

/// The frame at `origin` whose z runs along `axis`; x is chosen, the same for equal axes.
[[nodiscard]] inline Eigen::Isometry3d frameAt(const Eigen::Vector3d& origin, const Eigen::Vector3d& axis) {
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
  const Eigen::Vector3d z = axis.normalized();
  const Eigen::Vector3d x = z.unitOrthogonal();
  frame.linear() << x, z.cross(x), z;
  frame.translation() = origin;
  return frame;
}

}  // namespace geargraph
