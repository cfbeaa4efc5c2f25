#include "core/machine/arrangement/body_shapes.h"

#include <Eigen/Geometry>
#include <cmath>

namespace geargraph::inline arrangement {
namespace {

using Eigen::Vector3d;

const AxisLayout& axis(const Arrangement& plan, int c) {
  return plan.axes[static_cast<std::size_t>(c)];
}

double sineBetween(const AxisLayout& a, const AxisLayout& b) {
  return a.direction.cross(b.direction).norm();
}

}  // namespace

double holeFor(const Arrangement& plan, int axisClass, double at, int parent) {
  const double shaft = plan.shaftAt(axisClass, at, parent);
  return shaft > 0 ? shaft + eyePlay(axis(plan, axisClass)) : 0;
}

double eyeRadius(const Arrangement& plan, int axisClass, const Bearing& bearing) {
  return holeFor(plan, axisClass, bearing.at, bearing.parent) + bearing.wall * eyeWall(axis(plan, axisClass));
}

Eye footOf(const Arrangement& plan, const ArmPlan& arm) {
  const ShaftSegment* own = plan.shaftOf(arm.from, arm.link, arm.level);
  Eye eye;
  eye.hole = own != nullptr ? 0.5 * (own->inner + own->outer) : holeFor(plan, arm.from, arm.level, arm.link);
  eye.radius = (own != nullptr ? own->outer : eye.hole) + eyeWall(axis(plan, arm.from));
  return eye;
}

Eye endOf(const Arrangement& plan, const ArmPlan& arm) {
  const AxisLayout& from = axis(plan, arm.from);
  const AxisLayout& to = axis(plan, arm.to);
  const bool parallel = sineBetween(from, to) < 1e-6;
  const Eigen::Isometry3d frame = frameAlong(from.at(arm.level), from.direction, Vector3d::UnitX());
  const Vector3d local = frame.inverse() * to.at(arm.at);
  Eye eye;
  eye.hole = parallel ? holeFor(plan, arm.to, arm.at, arm.link) : 0;
  eye.radius = parallel ? eye.hole + eyeWall(to) : 1.5 * from.module;
  eye.centre = local.head<2>();
  return eye;
}

std::optional<Post> postOf(const Arrangement& plan, const ArmPlan& arm) {
  const AxisLayout& from = axis(plan, arm.from);
  const AxisLayout& to = axis(plan, arm.to);
  const double sine = sineBetween(from, to);
  if (sine < 1e-6) return std::nullopt;
  const Vector3d end = to.at(arm.at);
  const double rise = (end - from.at(arm.level)).dot(from.direction);
  // An oblique post's edge comes near first.
  const double cosine = std::abs(from.direction.dot(to.direction));
  Post post;
  post.foot = end - rise * from.direction;
  post.way = (rise < 0 ? -1 : 1) * from.direction;
  post.radius = endOf(plan, arm).radius;
  const double hole = holeFor(plan, arm.to, arm.at, arm.link);
  post.reach = std::abs(rise) - (hole + 0.5 * eyeWall(to) + post.radius * cosine) / sine;
  if (post.reach <= 0.5 * from.width()) return std::nullopt;
  return post;
}

}  // namespace geargraph::inline arrangement
