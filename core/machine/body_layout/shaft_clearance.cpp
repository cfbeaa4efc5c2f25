#include "core/machine/body_layout/shaft_clearance.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/machine/solids/gear_body.h"
#include "core/machine/teeth/wheel_kind.h"
#include "core/machine/train/wheel_envelopes.h"

namespace geargraph {

using Eigen::Vector3d;

namespace {

/// Does a shaft from what it holds to its bearing cross another axis? What turns about that one may need the
/// place.
bool isPastIntersection(const AxisLayout& layout, const Interval& held, double at) {
  return std::any_of(layout.occupied.begin(), layout.occupied.end(), [&](const Interval& s) {
    return s.link == -1 && layout.isBelow(std::min(held.low, at), s.low) &&
           layout.isBelow(s.high, std::max(held.high, at));
  });
}

/// Would a shaft part what another link has on the same axis, or a ring's plate come out through the wheels
/// within the ring?
bool isCutOff(const PlanDraft& draft, AxisGroupOrdinal axisGroup, LinkOrdinal link, const Interval& held,
              double at) {
  const AxisLayout& layout = draft.axis(axisGroup);
  const auto isBetween = [&](const Bearing& b) {
    const Interval other = heldInterval(draft, axisGroup, b.child);
    return b.child != link && layout.isBelow(other.low, at) && layout.isBelow(at, other.high);
  };
  if (std::any_of(layout.bearings.begin(), layout.bearings.end(), isBetween)) return true;
  const double middle = (held.low + held.high) / 2;
  const auto isAgainst = [&](const Bearing& b) {
    const Interval other = heldInterval(draft, axisGroup, b.child);
    if (!b.placed || !b.isBoss() || b.child == link || other.low > other.high) return false;
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
  return std::any_of(draft.plan.ringCarriers.begin(), draft.plan.ringCarriers.end(),
                     [&](const RingCarrierPlan& ringCarrier) {
                       const TrainGear& ring = draft.train.gears[ringCarrier.gear];
                       if (ring.link != link || ring.axisGroup != axisGroup || held.low < held.high)
                         return false;
                       return std::any_of(layout.wheels.begin(), layout.wheels.end(), [&](const Interval& s) {
                         return s.link != link && -ringCarrier.side * (at - ringCarrier.plate) > 0 &&
                                std::min(at, ringCarrier.plate) < s.low &&
                                s.high < std::max(at, ringCarrier.plate);
                       });
                     });
}

}  // namespace

Interval hubInterval(const PlanDraft& draft, AxisGroupOrdinal axisGroup, LinkOrdinal link) {
  Interval hubs{1e300, -1e300, link};
  for (const GearOrdinal g : draft.gearsOn[axisGroup]) {
    const TrainGear& gear = draft.train.gears[g];
    if (gear.link != link || isRing(gear.spec)) continue;
    const Interval hub = draft.intervalOf(gear, hubSpan(gear.spec));
    hubs.low = std::min(hubs.low, hub.low);
    hubs.high = std::max(hubs.high, hub.high);
  }
  return hubs;
}

Interval heldInterval(const PlanDraft& draft, AxisGroupOrdinal axisGroup, LinkOrdinal link) {
  Interval held = hubInterval(draft, axisGroup, link);
  for (const RingCarrierPlan& ringCarrier : draft.plan.ringCarriers) {
    const TrainGear& ring = draft.train.gears[ringCarrier.gear];
    if (ring.link != link || ring.axisGroup != axisGroup) continue;
    held.low = std::min(held.low, ringCarrier.plate);
    held.high = std::max(held.high, ringCarrier.plate);
  }
  return held;
}

bool shaftPasses(const PlanDraft& draft, const Bearing& bearing, double at) {
  const int c = draft.classOf(bearing);
  const AxisLayout& layout = draft.axis(c);
  const Interval held = heldInterval(draft, c, bearing.child);
  if (held.low > held.high) return true;
  if (isCutOff(draft, c, bearing.child, held, at)) return false;
  if (bearing.parent == 0 && isPastIntersection(layout, held, at)) return false;
  const double from = at < held.low ? at : std::min(held.high, at);
  const double to = at < held.low ? held.low : at;
  if (to - from < 1e-9 * layout.module) return true;
  const double radius = (kShaftRadius + 0.3) * layout.module;
  const WheelOrbit orbit = orbitOf(c, draft.placement);
  for (const TrainGear& gear : draft.train.gears) {
    if (gear.axisGroup == c || gear.link == bearing.child || !draft.parallel(c, gear.axisGroup)) continue;
    const double middle = layout.coordinate(gear.pose.translation());
    const double half = gear.spec.faceWidth / 2;
    if (!layout.overlap(middle - half, middle + half, from, to)) continue;
    const double distance = nearestAxes(orbit, orbitOf(gear.axisGroup, draft.placement), layout.direction);
    if (isRing(gear.spec)) {
      const Vector3d apart = draft.axis(gear.axisGroup).point - layout.point;
      const double now = (apart - apart.dot(layout.direction) * layout.direction).norm();
      if (now + radius > nominalTipRadius(gear.spec) && now - radius < rimDiameter(gear.spec) / 2)
        return false;
    } else if (distance < nominalTipRadius(gear.spec) + radius) {
      return false;
    }
  }
  const bool isThroughRingCarrier =
      std::any_of(draft.plan.ringCarriers.begin(), draft.plan.ringCarriers.end(),
                  [&](const RingCarrierPlan& ringCarrier) {
                    const TrainGear& ring = draft.train.gears[ringCarrier.gear];
                    if (ring.axisGroup == c || !draft.parallel(c, ring.axisGroup)) return false;
                    const double plate = draft.carried(ring.axisGroup, ringCarrier.plate, c),
                                 half = draft.axis(ring.axisGroup).width() / 2;
                    if (!layout.overlap(plate - half, plate + half, from, to)) return false;
                    const Vector3d apart = draft.axis(ring.axisGroup).point - layout.point;
                    const double now = (apart - apart.dot(layout.direction) * layout.direction).norm();
                    return now < rimDiameter(ring.spec) / 2 + radius;
                  });
  if (isThroughRingCarrier) return false;
  return bearing.parent != 0 ||
         draft.obstacles.nonParallelCollisions(bearing.child, layout.at(from), layout.at(to), radius,
                                               layout.direction) == 0;
}

std::ptrdiff_t enclosedBy(const PlanDraft& draft, LinkOrdinal link, AxisGroupOrdinal home, double level) {
  auto own = draft.axis(home).wheelsOf(link);
  if (!own) return 0;
  for (const Bearing& b : draft.axis(home).bearings) {
    if (b.child != link || !b.placed) continue;
    own->low = std::min(own->low, b.at);
    own->high = std::max(own->high, b.at);
  }
  const double low = std::min(own->high, level), high = std::max(own->low, level);
  return std::count_if(draft.axis(home).wheels.begin(), draft.axis(home).wheels.end(),
                       [&](const Interval& s) {
                         return s.link != link && draft.axis(home).overlap(low, high, s.low, s.high);
                       });
}

bool isTrapped(const PlanDraft& draft, LinkOrdinal link, AxisGroupOrdinal home, double level) {
  const Interval held = heldInterval(draft, home, link);
  if (held.low <= held.high) return false;
  const auto& bearings = draft.axis(home).bearings;
  return std::any_of(bearings.begin(), bearings.end(), [&](const Bearing& b) {
    return b.child == link && b.placed && b.isBoss() &&
           isCutOff(draft, home, link, {level, level, link}, b.at);
  });
}

bool meetsArms(const PlanDraft& draft, const Bearing& bearing, double at) {
  const int c = draft.classOf(bearing);
  const WheelOrbit orbit = orbitOf(c, draft.placement);
  if (orbit.about < 0) return false;
  const Interval held = heldInterval(draft, c, bearing.child);
  const double half = draft.axis(c).width() / 2, low = std::min(held.low, at) - half,
               high = std::max(held.high, at) + half;
  const double room = (kShaftRadius + 1) * draft.axis(c).module;
  const AxisLayout& centre = draft.axis(orbit.about);
  return std::any_of(draft.plan.arms.begin(), draft.plan.arms.end(), [&](const ArmPlan& arm) {
    if (arm.link == bearing.parent || !draft.parallel(arm.from, c) || !draft.parallel(arm.to, c))
      return false;
    const double level = draft.carried(arm.from, arm.level, c);
    if (level + half < low || high < level - half) return false;
    const auto off = [&](int k) {
      const Vector3d apart = draft.axis(k).point - centre.point;
      return (apart - apart.dot(centre.direction) * centre.direction).eval();
    };
    const Vector3d from = off(arm.from), bar = off(arm.to) - from;
    const double squared = bar.squaredNorm();
    const double part = squared > 0 ? std::clamp(-from.dot(bar) / squared, 0.0, 1.0) : 0;
    const double nearest = (from + part * bar).norm(), farthest = std::max(from.norm(), (from + bar).norm());
    return nearest - room < orbit.radius && orbit.radius < farthest + room;
  });
}

bool sweepsShafts(const PlanDraft& draft, LinkOrdinal link, AxisGroupOrdinal home, double level,
                  AxisGroupOrdinal axisGroup) {
  const AxisLayout& own = draft.axis(home);
  const auto away = [&](int c) {
    const Vector3d apart = draft.axis(c).point - own.point;
    return (apart - apart.dot(own.direction) * own.direction).norm();
  };
  if (axisGroup == home || draft.placement.classes->classes[home].rootLink != 0) return false;
  const double reach = away(axisGroup) + (kShaftRadius + 1) * own.module;
  return std::any_of(draft.heldBy[0].begin(), draft.heldBy[0].end(), [&](const auto& place) {
    const int c = place.first;
    const Bearing& bearing = draft.axis(c).bearings[place.second];
    if (c == home || !draft.parallel(home, c) || !bearing.placed || bearing.child == link || away(c) > reach)
      return false;
    const Interval held = heldInterval(draft, c, bearing.child);
    const double half = (own.width() + own.gap()) / 2 - 1e-6 * own.module, at = draft.carried(home, level, c);
    return std::min(held.low, bearing.at) - half < at && at < std::max(held.high, bearing.at) + half;
  });
}

}  // namespace geargraph
