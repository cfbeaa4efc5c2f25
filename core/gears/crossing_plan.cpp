#include <algorithm>
#include <cmath>

#include "core/gears/body_planner.h"

namespace geargraph {

using Eigen::Vector3d;

/// How many places of an arm with its post lie in gears of other links.
int BodyPlanner::armHits(const ArmPlan& arm) const {
  const AxisLayout& from = axis(arm.from);
  const Vector3d start = from.at(arm.level);
  const Vector3d end = axis(arm.to).at(arm.at);
  const Vector3d foot = end - (end - start).dot(from.direction) * from.direction;
  const double margin = 0.5 * from.width() + 0.3 * from.module;
  return m_obstacles.hits(arm.link, start, foot, margin) + m_obstacles.hits(arm.link, end, foot, margin) +
         shaftHits(arm);
}

/// How many places of an arm with its post lie in the shaft that its bearing holds, outside of the bearing,
/// or in what stands on the axis that the post runs along.
int BodyPlanner::shaftHits(const ArmPlan& arm) const {
  const AxisLayout& from = axis(arm.from);
  const AxisLayout& to = axis(arm.to);
  const Vector3d start = from.at(arm.level);
  const Vector3d end = to.at(arm.at);
  const Vector3d foot = end - (end - start).dot(from.direction) * from.direction;
  constexpr double kNear = 5.5;  // modules: a post beside an eye about two shafts
  int count = 0;
  if ((foot - start).norm() < kNear * from.module) {
    const auto [near, far] = std::minmax({arm.level, from.coordinate(end)});
    for (const Stretch& s : from.taken)
      count += s.link >= 0 && s.link != arm.link && s.low < far && near < s.high;
  }
  double low = arm.at - to.width() / 2;
  double high = arm.at + to.width() / 2;
  if (const auto wheels = to.wheelsOf(arm.child)) {
    low = std::min(low, wheels->low);
    high = std::max(high, wheels->high);
  }
  const double reach = kShaftRadius * to.module + 0.5 * from.width();
  const double sine = std::max(from.direction.cross(to.direction).norm(), 0.1);
  const double postEnd = (reach + 0.5 * to.module) / sine;  // nearer to the shaft the post does not come
  const auto isInShaft = [&](const Vector3d& p) {
    const double along = to.coordinate(p);
    return along > low && along < high && (p - to.at(along)).norm() < reach;
  };
  constexpr int kPlaces = 24;
  for (int i = 1; i <= kPlaces; ++i) {
    const double part = static_cast<double>(i) / kPlaces;
    const Vector3d onPost = end + part * (foot - end);
    const bool inBearing =
        std::abs(to.coordinate(onPost) - arm.at) <= to.width() / 2 || (onPost - end).norm() < postEnd;
    count += isInShaft(start + part * (foot - start)) ? 1 : 0;
    count += !inBearing && isInShaft(onPost) ? 1 : 0;
  }
  return count;
}

/// Where axes meet and a shaft with wheels on both sides passes the crossing, the link's own shaft can end in
/// an eye about it. Whatever else turns there on the link runs on the shaft that it encloses.
bool BodyPlanner::placeTee(int link, int home, int axisClass) {
  AxisLayout& own = axis(home);
  AxisLayout& target = axis(axisClass);
  const Vector3d across = own.direction.cross(target.direction);
  const Vector3d apart = target.point - own.point;
  if (link == 0 || std::abs(apart.dot(across)) > 0.01 * own.module * across.norm()) return false;
  const double level = apart.cross(target.direction).dot(across) / across.squaredNorm();
  const double at = target.coordinate(own.at(level));
  const auto isOthers = [](const Stretch& s, double low, double high) {
    return s.link >= 0 && s.low < high && low < s.high;
  };
  const double half = target.width() / 2 + target.gap() / 2;
  const double reach = (kShaftRadius + 1.5) * own.module;
  for (const Stretch& s : target.taken) {
    if (isOthers(s, at - half, at + half)) return false;
  }
  for (const Stretch& s : own.taken) {
    if (isOthers(s, level - reach, level + reach)) return false;
    if (s.link == link && s.low < level && level < s.high) return false;
  }
  const auto passes = [&](const Bearing& b) {
    const auto wheels = target.wheelsOf(b.child);
    return b.parent == link && !b.placed && wheels && wheels->low < at && wheels->high > at;
  };
  const auto through = std::find_if(target.bearings.begin(), target.bearings.end(), passes);
  if (through == target.bearings.end()) return false;
  if (std::count_if(target.bearings.begin(), target.bearings.end(), passes) != 1) return false;
  TeePlan tee{link, home, level, axisClass, at, through->child, at, at};
  for (const Bearing& b : target.bearings) {  // what runs on the shaft stands on one side
    const auto wheels = target.wheelsOf(b.child);
    if (&b == &*through || b.parent != link) continue;
    if (!wheels || b.placed || (wheels->low < at && wheels->high > at)) return false;
    tee.low = std::min(tee.low, wheels->low);
    tee.high = std::max(tee.high, wheels->high);
  }
  for (Bearing& b : target.bearings) {
    if (b.parent != link) continue;
    b.placed = true;
    b.at = at;
    b.form = &b == &*through ? BearingForm::eye : BearingForm::hidden;
  }
  const double cosine = std::abs(own.direction.dot(target.direction));
  through->wall = 1 + kShaftRadius * cosine;
  target.take(at, link);
  m_plan.tees.push_back(tee);
  return true;
}

/// The shafts of tees end in the walls of their eyes: not nearer than their edge may come to what turns
/// there.
void BodyPlanner::trimTees() {
  for (const TeePlan& tee : m_plan.tees) {
    const double hole = m_plan.shaftAt(tee.axisClass, tee.at, tee.link) + 0.08 * axis(tee.axisClass).module;
    const double sine = axis(tee.home).direction.cross(axis(tee.axisClass).direction).norm();
    const double cosine = std::abs(axis(tee.home).direction.dot(axis(tee.axisClass).direction));
    for (const std::size_t s : m_plan.shaftsOn[static_cast<std::size_t>(tee.home)]) {
      ShaftPlan& shaft = m_plan.shafts[s];
      if (shaft.link != tee.link) continue;
      const double off = (hole + 0.4 * axis(tee.home).module + shaft.outer * cosine) / sine;
      if (std::abs(shaft.high - tee.level) < std::abs(shaft.low - tee.level)) {
        shaft.high = tee.level - off;
      } else {
        shaft.low = tee.level + off;
      }
    }
  }
}

/// Where axes meet, a link can hold out a pin along the other from its own shaft, for wheels that all stand
/// on one side; nobody else's wheels or shafts may be in the way.
std::optional<PinPlan> BodyPlanner::pinFor(int link, int home, const Bearing& bearing) const {
  const int c = m_placement.classes->classOf[static_cast<std::size_t>(bearing.joint)];
  const AxisLayout& own = axis(home);
  const AxisLayout& target = axis(c);
  const auto wheels = target.wheelsOf(bearing.child);
  const Vector3d across = own.direction.cross(target.direction);
  const Vector3d apart = target.point - own.point;
  if (!wheels || std::abs(apart.dot(across)) > 0.01 * own.module * across.norm()) return std::nullopt;
  PinPlan pin{link, home, apart.cross(target.direction).dot(across) / across.squaredNorm(), c};
  pin.from = target.coordinate(own.at(pin.level));
  if (wheels->low < pin.from && wheels->high > pin.from) return std::nullopt;
  const double end = 2 * target.gap();
  pin.to = wheels->low >= pin.from ? wheels->high + end : wheels->low - end;
  const auto inTheWay = [&](const Stretch& s) {
    return s.link >= 0 && s.link != bearing.child && s.low < std::max(pin.from, pin.to) &&
           s.high > std::min(pin.from, pin.to);
  };
  if (std::any_of(target.taken.begin(), target.taken.end(), inTheWay)) return std::nullopt;
  for (const Bearing& other : own.bearings) {  // shafts of others through the crossing
    if (other.child == link || !other.isEye()) continue;
    const auto span = own.wheelsOf(other.child);
    const double low = std::min(other.at, span ? span->low : other.at);
    const double high = std::max(other.at, span ? span->high : other.at);
    if (low < pin.level && high > pin.level) return std::nullopt;
  }
  return pin;
}

/// Bearing and arm for an axis that crosses the link's own. Bearings go where they are drawn if that is free,
/// arms beside the link's own wheel or where it has one already; but first of all where they pass the gears.
void BodyPlanner::placeCrossing(int link, int home, Bearing& bearing) {
  const int c = m_placement.classes->classOf[static_cast<std::size_t>(bearing.joint)];
  AxisLayout& target = axis(c);
  AxisLayout& own = axis(home);
  std::vector<double> places{bearing.at, target.outerSlot()};
  for (const double x : target.slotCandidates()) places.push_back(x);
  std::vector<double> levels{own.outerSlot()};
  const double reach = own.gap() + own.width() / 2;
  for (const Stretch& s : own.taken) {
    if (s.link != link) continue;
    levels.push_back(s.high + reach);
    levels.push_back(s.low - reach);
  }
  if (levels.size() == 1) levels = own.slotCandidates();
  std::vector<double> standing;
  for (const std::size_t a : m_armsOf[static_cast<std::size_t>(link)])
    standing.push_back(m_plan.arms[a].level);
  ArmPlan best;
  double bestCost = 1e300;
  int bestHits = 0;
  const auto consider = [&](double at, double level, double extra) {
    const ArmPlan arm{link, home, level, c, at, bearing.child};
    constexpr int kInside = 20;  // an arm that cannot come out weighs as much as so many places in gears
    const int hits = armHits(arm) + (own.emerges(link, level) ? 0 : kInside);
    const double cost = 100 * own.module * hits + std::abs(at - bearing.at) +
                        std::abs(level - own.coordinate(target.at(at))) + extra;
    if (cost < bestCost - 1e-9) {
      best = arm;
      bestCost = cost;
      bestHits = hits;
    }
  };
  for (const double at : places) {
    if (!target.slotIsFree(at)) continue;
    for (const double level : standing) consider(at, level, 0);
    for (const double level : levels) {
      if (own.slotIsFree(level)) consider(at, level, 6 * own.module);
    }
  }
  bearing.placed = true;
  if (const auto pin = bestHits > 0 ? pinFor(link, home, bearing) : std::nullopt) {
    bearing.form = BearingForm::pin;
    bearing.at = pin->to;
    m_plan.pins.push_back(*pin);
    return;
  }
  if (bestHits > 0) m_plan.blocked.push_back({link, bearing.child});
  bearing.at = best.at;
  target.take(best.at, link);
  if (std::find(standing.begin(), standing.end(), best.level) == standing.end()) own.take(best.level, link);
  addArm(best);
}

}  // namespace geargraph
