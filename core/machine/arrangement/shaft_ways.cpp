// Where a shaft comes out: past the wheels of its own axis and of others, and past arms.

#include <algorithm>
#include <cmath>

#include "core/machine/arrangement/body_planner.h"
#include "core/machine/solids/gear_body.h"
#include "core/machine/train/wheel_rooms.h"

namespace geargraph::inline arrangement {

using Eigen::Vector3d;

namespace {

/// Does a shaft from what it holds to its bearing cross another axis? What turns about that one may need the
/// place.
bool isPastCrossing(const AxisLayout& layout, const Stretch& held, double at) {
  return std::any_of(layout.taken.begin(), layout.taken.end(), [&](const Stretch& s) {
    return s.link == -1 && layout.isBelow(std::min(held.low, at), s.low) &&
           layout.isBelow(s.high, std::max(held.high, at));
  });
}

}  // namespace

/// The hubs of a link's wheels on the axis, but for rings. Empty where there are none.
Stretch BodyPlanner::hubStretch(int axisClass, int link) const {
  const AxisLayout& layout = axis(axisClass);
  Stretch hubs{1e300, -1e300, link};
  for (const std::size_t g : m_gearsOn[static_cast<std::size_t>(axisClass)]) {
    const TrainGear& gear = m_train.gears[g];
    if (gear.link != link || gear.spec.kind == GearKind::internal) continue;
    const AxialSpan span = hubSpan(gear.spec);
    const double sense = gear.pose.linear().col(2).dot(layout.direction) < 0 ? -1 : 1;
    const double origin = layout.coordinate(gear.pose.translation());
    for (const double z : {span.low, span.high}) {
      hubs.low = std::min(hubs.low, origin + sense * z);
      hubs.high = std::max(hubs.high, origin + sense * z);
    }
  }
  return hubs;
}

/// What a link's shaft holds on the axis: wheels, and the plates of rings, which are hollow. Empty where
/// there is nothing.
Stretch BodyPlanner::heldStretch(int axisClass, int link) const {
  Stretch held = hubStretch(axisClass, link);
  for (const CupPlan& cup : m_plan.cups) {
    const TrainGear& ring = m_train.gears[static_cast<std::size_t>(cup.gear)];
    if (ring.link != link || ring.axisClass != axisClass) continue;
    held.low = std::min(held.low, cup.plate);
    held.high = std::max(held.high, cup.plate);
  }
  return held;
}

/// Would a shaft part what another link has on the same axis, or a ring's plate come out through the wheels
/// within the ring?
bool BodyPlanner::isCutOff(int axisClass, int link, const Stretch& held, double at) const {
  const AxisLayout& layout = axis(axisClass);
  const auto isBetween = [&](const Bearing& b) {
    const Stretch other = heldStretch(axisClass, b.child);
    return b.child != link && layout.isBelow(other.low, at) && layout.isBelow(at, other.high);
  };
  if (std::any_of(layout.bearings.begin(), layout.bearings.end(), isBetween)) return true;
  const double middle = (held.low + held.high) / 2;
  const auto isAgainst = [&](const Bearing& b) {
    const Stretch other = heldStretch(axisClass, b.child);
    if (!b.placed || !b.isEye() || b.child == link || other.low > other.high) return false;
    const double others = (other.low + other.high) / 2;
    const auto passes = [&](double from, double to, double x) {
      return layout.isBelow(from, x) == layout.isBelow(x, to);
    };
    const bool passed = passes(middle, at, others), isPassed = passes(others, b.at, middle);
    if (passed && isPassed) return true;
    // The outer shaft of two ends before the inner one.
    if (passed && passes(middle, b.at, others)) return !passes(others, at, b.at);
    if (isPassed && passes(others, at, middle)) return !passes(middle, b.at, at);
    return false;
  };
  if (std::any_of(layout.bearings.begin(), layout.bearings.end(), isAgainst)) return true;
  return std::any_of(m_plan.cups.begin(), m_plan.cups.end(), [&](const CupPlan& cup) {
    const TrainGear& ring = m_train.gears[static_cast<std::size_t>(cup.gear)];
    if (ring.link != link || ring.axisClass != axisClass || held.low < held.high) return false;
    return std::any_of(layout.wheels.begin(), layout.wheels.end(), [&](const Stretch& s) {
      return s.link != link && -cup.side * (at - cup.plate) > 0 && std::min(at, cup.plate) < s.low &&
             s.high < std::max(at, cup.plate);
    });
  });
}

/// Does the shaft of the link that a bearing holds, from its wheels to there, stay clear of the wheels on
/// other axes, wherever their carriers take them?
bool BodyPlanner::shaftPasses(const Bearing& bearing, double at) const {
  const int c = classOf(bearing);
  const AxisLayout& layout = axis(c);
  const Stretch held = heldStretch(c, bearing.child);
  if (held.low > held.high) return true;
  if (isCutOff(c, bearing.child, held, at)) return false;
  if (bearing.parent == 0 && isPastCrossing(layout, held, at)) return false;
  const double from = at < held.low ? at : std::min(held.high, at);
  const double to = at < held.low ? held.low : at;
  if (to - from < 1e-9 * layout.module) return true;
  const double radius = (kShaftRadius + 0.3) * layout.module;
  const WheelOrbit orbit = orbitOf(c, m_placement);
  for (const TrainGear& gear : m_train.gears) {
    if (gear.axisClass == c || gear.link == bearing.child || !parallel(c, gear.axisClass)) continue;
    const double middle = layout.coordinate(gear.pose.translation());
    const double half = gear.spec.faceWidth / 2;
    if (!layout.overlap(middle - half, middle + half, from, to)) continue;
    const double distance = nearestAxes(orbit, orbitOf(gear.axisClass, m_placement), layout.direction);
    if (gear.spec.kind == GearKind::internal) {
      const Vector3d apart = axis(gear.axisClass).point - layout.point;
      const double now = (apart - apart.dot(layout.direction) * layout.direction).norm();
      if (now + radius > nominalTipRadius(gear.spec) && now - radius < rimDiameter(gear.spec) / 2)
        return false;
    } else if (distance < nominalTipRadius(gear.spec) + radius) {
      return false;
    }
  }
  const bool isThroughCup = std::any_of(m_plan.cups.begin(), m_plan.cups.end(), [&](const CupPlan& cup) {
    const TrainGear& ring = m_train.gears[static_cast<std::size_t>(cup.gear)];
    if (ring.axisClass == c || !parallel(c, ring.axisClass)) return false;
    const double plate = carried(ring.axisClass, cup.plate, c), half = axis(ring.axisClass).width() / 2;
    if (!layout.overlap(plate - half, plate + half, from, to)) return false;
    const Vector3d apart = axis(ring.axisClass).point - layout.point;
    const double now = (apart - apart.dot(layout.direction) * layout.direction).norm();
    return now < rimDiameter(ring.spec) / 2 + radius;
  });
  if (isThroughCup) return false;
  return bearing.parent != 0 || m_obstacles.crossingHits(bearing.child, layout.at(from), layout.at(to),
                                                         radius, layout.direction) == 0;
}

/// Wheels of others on the axis between a level and what the link has there, its bearing included.
std::ptrdiff_t BodyPlanner::enclosedBy(int link, int home, double level) const {
  auto own = axis(home).wheelsOf(link);
  if (!own) return 0;
  for (const Bearing& b : axis(home).bearings) {
    if (b.child != link || !b.placed) continue;
    own->low = std::min(own->low, b.at);
    own->high = std::max(own->high, b.at);
  }
  const double low = std::min(own->high, level), high = std::max(own->low, level);
  return std::count_if(axis(home).wheels.begin(), axis(home).wheels.end(), [&](const Stretch& s) {
    return s.link != link && axis(home).overlap(low, high, s.low, s.high);
  });
}

/// Does a carrier with nothing but its arm on its axis come from there to its bearing through what others
/// have?
bool BodyPlanner::isTrapped(int link, int home, double level) const {
  const Stretch held = heldStretch(home, link);
  if (held.low <= held.high) return false;
  const auto& bearings = axis(home).bearings;
  return std::any_of(bearings.begin(), bearings.end(), [&](const Bearing& b) {
    return b.child == link && b.placed && b.isEye() && isCutOff(home, link, {level, level, link}, b.at);
  });
}

/// Does the shaft that a carrier holds go round through an arm of another link?
bool BodyPlanner::meetsArms(const Bearing& bearing, double at) const {
  const int c = classOf(bearing);
  const WheelOrbit orbit = orbitOf(c, m_placement);
  if (orbit.about < 0) return false;
  const Stretch held = heldStretch(c, bearing.child);
  const double half = axis(c).width() / 2, low = std::min(held.low, at) - half,
               high = std::max(held.high, at) + half;
  const double room = (kShaftRadius + 1) * axis(c).module;
  const AxisLayout& centre = axis(orbit.about);
  return std::any_of(m_plan.arms.begin(), m_plan.arms.end(), [&](const ArmPlan& arm) {
    if (arm.link == bearing.parent || !parallel(arm.from, c) || !parallel(arm.to, c)) return false;
    const double level = carried(arm.from, arm.level, c);
    if (level + half < low || high < level - half) return false;
    const auto off = [&](int k) {
      const Vector3d apart = axis(k).point - centre.point;
      return (apart - apart.dot(centre.direction) * centre.direction).eval();
    };
    const Vector3d from = off(arm.from), bar = off(arm.to) - from;
    const double squared = bar.squaredNorm();
    const double part = squared > 0 ? std::clamp(-from.dot(bar) / squared, 0.0, 1.0) : 0;
    const double nearest = (from + part * bar).norm(), farthest = std::max(from.norm(), (from + bar).norm());
    return nearest - room < orbit.radius && orbit.radius < farthest + room;
  });
}

/// Does a carrier's arm to an axis go round through a shaft of the frame?
bool BodyPlanner::sweepsShafts(int link, int home, double level, int axisClass) const {
  const AxisLayout& own = axis(home);
  const auto away = [&](int c) {
    const Vector3d apart = axis(c).point - own.point;
    return (apart - apart.dot(own.direction) * own.direction).norm();
  };
  if (axisClass == home || m_placement.classes->classes[static_cast<std::size_t>(home)].top != 0)
    return false;
  const double reach = away(axisClass) + (kShaftRadius + 1) * own.module;
  return std::any_of(m_heldBy[0].begin(), m_heldBy[0].end(), [&](const auto& place) {
    const int c = place.first;
    const Bearing& bearing = axis(c).bearings[place.second];
    if (c == home || !parallel(home, c) || !bearing.placed || bearing.child == link || away(c) > reach)
      return false;
    const Stretch held = heldStretch(c, bearing.child);
    const double half = (own.width() + own.gap()) / 2 - 1e-6 * own.module, at = carried(home, level, c);
    return std::min(held.low, bearing.at) - half < at && at < std::max(held.high, bearing.at) + half;
  });
}

}  // namespace geargraph::inline arrangement
