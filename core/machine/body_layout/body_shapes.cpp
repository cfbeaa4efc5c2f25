#include "core/machine/body_layout/body_shapes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace geargraph {
namespace {

using Eigen::Vector3d;

const AxisLayout& axis(const Arrangement& plan, int c) {
  return plan.axes[c];
}

constexpr double kStandoff =
    1.5;  // modules: radius of a standoff and of the end of the arm that it stands on

double sineBetween(const AxisLayout& a, const AxisLayout& b) {
  return a.direction.cross(b.direction).norm();
}

}  // namespace

double holeFor(const Arrangement& plan, AxisGroupOrdinal axisGroup, double at, int parent) {
  const double shaft = plan.shaftAt(axisGroup, at, parent);
  return shaft > 0 ? shaft + bossClearance(axis(plan, axisGroup)) : 0;
}

double bossRadius(const Arrangement& plan, AxisGroupOrdinal axisGroup, const Bearing& bearing) {
  return holeFor(plan, axisGroup, bearing.at, bearing.parent) +
         bearing.wall * bossWall(axis(plan, axisGroup));
}

Boss footOf(const Arrangement& plan, const ArmPlan& arm) {
  const ShaftSegment* own = plan.shaftOf(arm.from, arm.link, arm.level);
  Boss boss;
  boss.hole = own != nullptr ? 0.5 * (own->inner + own->outer) : holeFor(plan, arm.from, arm.level, arm.link);
  boss.radius = (own != nullptr ? own->outer : boss.hole) + bossWall(axis(plan, arm.from));
  return boss;
}

Boss endOf(const Arrangement& plan, const ArmPlan& arm) {
  const AxisLayout& from = axis(plan, arm.from);
  const AxisLayout& to = axis(plan, arm.to);
  const bool parallel = sineBetween(from, to) < 1e-6;
  const auto standoff = standoffOf(plan, arm);
  const Eigen::Isometry3d frame = frameAlong(from.at(arm.level), from.direction, Vector3d::UnitX());
  const Vector3d local = frame.inverse() * (standoff ? standoff->foot : to.at(arm.at));
  Boss boss;
  boss.hole = parallel ? holeFor(plan, arm.to, arm.at, arm.link) : 0;
  boss.radius = parallel ? boss.hole + bossWall(to) : kStandoff * from.module;
  boss.centre = local.head<2>();
  return boss;
}

StandoffEnd standoffEnd(const AxisLayout& from, const AxisLayout& to, double hole, double sense) {
  const double radius = kStandoff * from.module, wall = 0.5 * bossWall(to);
  const double cosine = from.direction.dot(to.direction), sine = sineBetween(from, to);
  const double lean = std::abs(cosine);
  // In the plane of both directions: how far the end's middle is from the boss's axis, and the length along
  // that axis of what lies within the wall.
  const double away = hole + wall + radius * lean;
  StandoffEnd end{Vector3d::Zero(), away * sine};
  if (lean < 1e-9) return end;
  const double within = sine * std::min(wall / lean, 2 * radius);
  const double along = std::max(0.0, radius * sine - within / 2 - to.width() / 4);
  const Vector3d way = sense * from.direction;
  const Vector3d onwards = (sense * cosine < 0 ? -1 : 1) * to.direction;  // as the standoff runs
  end.aside = (along * sine + away * lean) / sine * (onwards - lean * way);
  end.before -= along * lean;
  return end;
}

std::optional<Standoff> standoffOf(const Arrangement& plan, const ArmPlan& arm) {
  const AxisLayout& from = axis(plan, arm.from);
  const AxisLayout& to = axis(plan, arm.to);
  if (sineBetween(from, to) < 1e-6) return std::nullopt;
  const Vector3d end = to.at(arm.at);
  const double rise = (end - from.at(arm.level)).dot(from.direction);
  const double sense = rise < 0 ? -1 : 1;
  const StandoffEnd met = standoffEnd(from, to, holeFor(plan, arm.to, arm.at, arm.link), sense);
  Standoff standoff;
  standoff.foot = end - rise * from.direction + met.aside;
  standoff.way = sense * from.direction;
  standoff.radius = kStandoff * from.module;
  standoff.reach = std::abs(rise) - met.before;
  if (standoff.reach <= 0.5 * from.width()) return std::nullopt;
  return standoff;
}

}  // namespace geargraph
