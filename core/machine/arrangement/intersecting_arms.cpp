#include "core/machine/arrangement/intersecting_arms.h"

#include <algorithm>
#include <cmath>

#include "core/machine/arrangement/body_shapes.h"
#include "core/machine/arrangement/pedestals.h"
#include "core/machine/solids/gear_body.h"

namespace geargraph::inline arrangement {

using Eigen::Vector3d;

namespace {

struct TriedArm {
  ArmPlan arm;
  int collisions = 1 << 20;  ///< places that do not pass
};

/// How far the link's shaft reaches along its own axis with this arm.
Interval reachOf(const PlanDraft& draft, const ArmPlan& arm) {
  const AxisLayout& own = draft.axis(arm.from);
  Interval reach{arm.level, arm.level, arm.link};
  const auto include = [&](double low, double high) {
    reach.low = std::min(reach.low, low);
    reach.high = std::max(reach.high, high);
  };
  for (const Interval& s : own.occupied) {
    if (s.link == arm.link) include(s.low, s.high);
  }
  for (const Bearing& b : own.bearings) {
    if (b.child == arm.link) include(b.at, b.at);
  }
  return reach;
}

/// The middle lines of an arm across to another axis: from its own axis to the foot of its standoff, and on
/// to the boss's middle. An oblique standoff passes beside that, and its line ends where it does, as shafts
/// are whose radii are not known yet.
struct ArmLines {
  Vector3d start, foot, end;
};

ArmLines linesOf(const AxisLayout& from, const AxisLayout& to, const ArmPlan& arm) {
  ArmLines lines{from.at(arm.level), {}, to.at(arm.at)};
  const double rise = (lines.end - lines.start).dot(from.direction), sense = rise < 0 ? -1 : 1;
  lines.foot = lines.end - rise * from.direction;
  const StandoffEnd met = standoffEnd(from, to, kShaftRadius * to.module + bossClearance(to), sense);
  if (met.aside.isZero() || std::abs(rise) - met.before <= 0.5 * from.width()) return lines;
  lines.foot += met.aside;
  lines.end += met.aside - met.before * sense * from.direction;
  return lines;
}

/// How many places of an arm with its standoff lie in the shaft that its bearing holds, outside of the
/// bearing, or in what stands on the axis that the standoff runs along.
int shaftCollisions(const PlanDraft& draft, const ArmPlan& arm) {
  const AxisLayout& from = draft.axis(arm.from);
  const AxisLayout& to = draft.axis(arm.to);
  const auto [start, foot, end] = linesOf(from, to, arm);
  const Vector3d boss = to.at(arm.at);
  constexpr double kNear = 5.5;  // modules: a standoff beside a boss about two shafts
  int count = 0;
  if ((foot - start).norm() < kNear * from.module) {
    const auto [near, far] = std::minmax({arm.level, from.coordinate(boss)});
    for (const Interval& s : from.occupied)
      count += s.link >= 0 && s.link != arm.link && from.overlap(s.low, s.high, near, far);
  }
  double low = arm.at - to.width() / 2;
  double high = arm.at + to.width() / 2;
  if (const auto wheels = to.wheelsOf(arm.child)) {
    low = std::min(low, wheels->low);
    high = std::max(high, wheels->high);
  }
  if (const auto intersection = draft.intersectionOf(arm.from, arm.to)) {
    constexpr int kThrough = 6;  // places in gears that shafts through each other weigh as much as
    const Interval own = reachOf(draft, arm);
    const bool through = from.isBelow(own.low, intersection->first) &&
                         from.isBelow(intersection->first, own.high) &&
                         to.isBelow(low, intersection->second) && to.isBelow(intersection->second, high);
    count += through ? kThrough : 0;
  }
  const double reach = kShaftRadius * to.module + 0.5 * from.width();
  const double sine = std::max(from.direction.cross(to.direction).norm(), 0.1);
  const double nearest = (reach + 0.5 * to.module) / sine;  // that the standoff comes to the shaft
  const auto isInShaft = [&](const Vector3d& p) {
    const double along = to.coordinate(p);
    return to.isBelow(low, along) && to.isBelow(along, high) && to.isBelow((p - to.at(along)).norm(), reach);
  };
  constexpr int kSamples = 24;
  for (int i = 1; i <= kSamples; ++i) {
    const double part = static_cast<double>(i) / kSamples;
    const Vector3d onStandoff = end + part * (foot - end);
    const bool inBearing = !to.isBelow(to.width() / 2, std::abs(to.coordinate(onStandoff) - arm.at)) ||
                           to.isBelow((onStandoff - boss).norm(), nearest);
    count += isInShaft(start + part * (foot - start)) ? 1 : 0;
    count += !inBearing && isInShaft(onStandoff) ? 1 : 0;
  }
  return count;
}

/// How many places of an arm with its standoff lie in gears of other links.
int armCollisions(const PlanDraft& draft, const ArmPlan& arm) {
  const AxisLayout& from = draft.axis(arm.from);
  const auto [start, foot, end] = linesOf(from, draft.axis(arm.to), arm);
  const double margin = 0.5 * from.width() + 0.3 * from.module;
  return draft.obstacles.collisions(arm.link, start, foot, margin) +
         draft.obstacles.collisions(arm.link, end, foot, margin) + shaftCollisions(draft, arm);
}

/// Levels beside the link's own wheel and arms, or outside of everything.
std::vector<double> levelsBeside(const PlanDraft& draft, LinkOrdinal link, ClassOrdinal home) {
  const AxisLayout& own = draft.axis(home);
  std::vector<double> levels{own.outerSlot()};
  const double reach = own.gap() + own.width() / 2;
  for (const Interval& s : own.occupied) {
    if (s.link != link) continue;
    levels.push_back(s.high + reach);
    levels.push_back(s.low - reach);
  }
  if (levels.size() == 1) levels = own.slotCandidates();
  return levels;
}

/// Levels beyond the wheels on an axis that crosses, so that an arm goes round them.
std::vector<double> levelsBeyond(const PlanDraft& draft, ClassOrdinal home, ClassOrdinal axisClass) {
  const AxisLayout& own = draft.axis(home);
  std::vector<double> levels;
  for (const GearOrdinal g : draft.gearsOn[axisClass]) {
    const TrainGear& gear = draft.train.gears[g];
    const double beyond = nominalTipRadius(gear.spec) + own.width() / 2 + own.gap();
    const double middle = own.coordinate(gear.pose.translation());
    levels.insert(levels.end(), {middle + beyond, middle - beyond});
  }
  return levels;
}

/// The arm to the bearing's axis that passes most, then the shortest.
TriedArm bestArm(const PlanDraft& draft, LinkOrdinal link, ClassOrdinal home, const Bearing& bearing,
                 const std::vector<double>& levels) {
  const int c = draft.classOf(bearing);
  const AxisLayout& target = draft.axis(c);
  const AxisLayout& own = draft.axis(home);
  std::vector<double> places{bearing.at, target.outerSlot()};
  for (const double x : target.slotCandidates()) places.push_back(x);
  TriedArm best;
  double bestCost = 1e300;
  const auto consider = [&](double at, double level, double extra) {
    const ArmPlan arm{link, home, level, c, at, bearing.child};
    constexpr int kInside = 20;  // an arm that cannot come out weighs as much as so many places in gears
    const int collisions = armCollisions(draft, arm) + (own.emerges(link, level) ? 0 : kInside);
    const double cost = 100 * own.module * collisions + std::abs(at - bearing.at) +
                        std::abs(level - own.coordinate(target.at(at))) + extra;
    if (cost >= bestCost - 1e-9 * own.module) return;
    best = {arm, collisions};
    bestCost = cost;
  };
  for (const double at : places) {
    if (draft.isStopped()) break;
    if (!target.slotIsFree(at)) continue;
    for (const std::size_t a : draft.armsOf[link]) consider(at, draft.plan.arms[a].level, 0);
    for (const double level : levels) {
      if (own.slotIsFree(level)) consider(at, level, 6 * own.module);
    }
  }
  return best;
}

}  // namespace

std::optional<PinPlan> pinFor(const PlanDraft& draft, LinkOrdinal link, ClassOrdinal home,
                              const Bearing& bearing) {
  const int c = draft.classOf(bearing);
  const AxisLayout& own = draft.axis(home);
  const AxisLayout& target = draft.axis(c);
  const auto wheels = target.wheelsOf(bearing.child);
  const auto intersection = draft.intersectionOf(home, c);
  if (!wheels || !intersection) return std::nullopt;
  PinPlan pin{link, home, intersection->first, c};
  pin.from = intersection->second;
  if (target.isBelow(wheels->low, pin.from) && target.isBelow(pin.from, wheels->high)) return std::nullopt;
  const double end = 2 * target.gap();
  pin.to = target.isBelow(wheels->low, pin.from) ? wheels->low - end : wheels->high + end;
  const auto inTheWay = [&](const Interval& s) {
    return s.link >= 0 && s.link != bearing.child &&
           target.overlap(s.low, s.high, std::min(pin.from, pin.to), std::max(pin.from, pin.to));
  };
  if (std::any_of(target.occupied.begin(), target.occupied.end(), inTheWay)) return std::nullopt;
  for (const Bearing& other : own.bearings) {  // shafts of others through the intersection
    if (other.child == link || !other.isBoss()) continue;
    const auto span = own.wheelsOf(other.child);
    const double low = std::min(other.at, span ? span->low : other.at);
    const double high = std::max(other.at, span ? span->high : other.at);
    if (own.isBelow(low, pin.level) && own.isBelow(pin.level, high)) return std::nullopt;
  }
  return pin;
}

void placeIntersecting(PlanDraft& draft, LinkOrdinal link, ClassOrdinal home, Bearing& bearing) {
  if (draft.tries.onPedestals.contains(bearing.child) && link == 0)
    return putOnPedestalOrReport(draft, bearing);
  TriedArm best = bestArm(draft, link, home, bearing, levelsBeside(draft, link, home));
  if (const auto place = best.collisions > 0 && link == 0 ? pedestalPlace(draft, bearing) : std::nullopt)
    return putOnPedestal(draft, bearing, *place);
  bearing.placed = true;
  if (const auto pin = best.collisions > 0 ? pinFor(draft, link, home, bearing) : std::nullopt) {
    bearing.form = BearingForm::pin;
    bearing.at = pin->to;
    draft.plan.pins.push_back(*pin);
    return;
  }
  const int c = draft.classOf(bearing);
  if (best.collisions > 0) {
    const TriedArm other = bestArm(draft, link, home, bearing, levelsBeyond(draft, home, c));
    if (other.collisions < best.collisions) best = other;
  }
  if (best.collisions > 0) draft.plan.blocked.push_back({link, bearing.child});
  bearing.at = best.arm.at;
  draft.axis(c).occupy(best.arm.at, link);
  const auto& arms = draft.armsOf[link];
  const bool stands = std::any_of(arms.begin(), arms.end(),
                                  [&](std::size_t a) { return draft.plan.arms[a].level == best.arm.level; });
  if (!stands) draft.axis(home).occupy(best.arm.level, link);
  draft.addArm(best.arm);
}

}  // namespace geargraph::inline arrangement
