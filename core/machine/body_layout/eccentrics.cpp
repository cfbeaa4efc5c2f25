#include "core/machine/body_layout/eccentrics.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace geargraph {
namespace {

constexpr double kThrow = 2 * kShaftRadius;  ///< modules: farther apart, two shafts pass each other

double distanceOf(const PlanDraft& draft, AxisGroupOrdinal a, AxisGroupOrdinal b) {
  const Eigen::Vector3d apart = draft.axis(b).point - draft.axis(a).point;
  const Eigen::Vector3d& along = draft.axis(a).direction;
  return (apart - apart.dot(along) * along).norm();
}

}  // namespace

bool isEccentric(const PlanDraft& draft, AxisGroupOrdinal home, AxisGroupOrdinal axisGroup) {
  if (home == axisGroup || !draft.parallel(home, axisGroup)) return false;
  const double distance = distanceOf(draft, home, axisGroup), module = draft.axis(home).module;
  return distance > kSameLevel * module && distance < kThrow * module;
}

bool placeEccentric(PlanDraft& draft, LinkOrdinal link, AxisGroupOrdinal home, Bearing& bearing) {
  const int c = draft.classOf(bearing);
  AxisLayout& own = draft.axis(home);
  AxisLayout& target = draft.axis(c);
  const auto wheels = target.wheelsOf(bearing.child);
  const auto held = std::find_if(own.bearings.begin(), own.bearings.end(),
                                 [&](const Bearing& b) { return b.child == link && b.placed; });
  if (!wheels || target.bearings.size() != 1 || held == own.bearings.end()) return false;
  const double from = draft.carried(home, held->at, c);
  const double side = target.isBelow(from, (wheels->low + wheels->high) / 2) ? -1 : 1;  // of the disc
  const double reach = target.gap() + target.width() / 2;
  const double disc = side < 0 ? wheels->low - reach : wheels->high + reach;
  const double collar = side < 0 ? wheels->high + reach : wheels->low - reach;
  const double level = draft.carried(c, disc, home);
  if (!target.slotIsFree(disc) || !target.slotIsFree(collar) || !own.slotIsFree(level) ||
      !own.slotIsFree(draft.carried(c, collar, home)))
    return false;
  bearing.form = BearingForm::pin;
  bearing.at = collar;
  bearing.placed = true;
  target.occupy(disc, link);
  target.occupy(collar, link);
  own.occupy(level, link);
  own.occupy(draft.carried(c, collar, home), link);
  // The shaft ends a little beyond the disc's face: no face of one lies on the other's.
  const double sense = draft.axis(c).direction.dot(own.direction) < 0 ? -1 : 1;
  const double half = own.width() / 2, towards = -side * sense;
  PinPlan pin{link, home, level + towards * (half - 0.3 * own.gap()), c, disc, 0};
  pin.to = collar - side * 0.1 * target.width();
  draft.plan.pins.push_back(pin);
  const double throwOf = distanceOf(draft, home, c);
  const double rim = throwOf + (kShaftRadius + 0.5) * own.module, hole = 0.5 * kShaftRadius * own.module;
  draft.plan.revolvedBodies.push_back(
      {home, link, {{{rim, level - half}, {rim, level + half}, {hole, level + half}, {hole, level - half}}}});
  draft.plan.walls.push_back({home, link, level, level, 0, throwOf, true});
  return true;
}

}  // namespace geargraph
