#include <algorithm>
#include <cmath>

#include "core/machine/arrangement/body_planner.h"

namespace geargraph::inline arrangement {

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

/// Where two axes meet: the coordinates of the point along them; nothing where they are skew.
std::optional<std::pair<double, double>> BodyPlanner::crossingOf(int a, int b) const {
  const AxisLayout& one = axis(a);
  const AxisLayout& other = axis(b);
  const Vector3d across = one.direction.cross(other.direction);
  const Vector3d apart = other.point - one.point;
  if (across.norm() < 1e-6 || std::abs(apart.dot(across)) > 0.01 * one.module * across.norm())
    return std::nullopt;
  const double level = apart.cross(other.direction).dot(across) / across.squaredNorm();
  return std::pair{level, other.coordinate(one.at(level))};
}

/// How far the link's shaft reaches along its own axis with this arm.
Stretch BodyPlanner::reachOf(const ArmPlan& arm) const {
  const AxisLayout& own = axis(arm.from);
  Stretch reach{arm.level, arm.level, arm.link};
  const auto include = [&](double low, double high) {
    reach.low = std::min(reach.low, low);
    reach.high = std::max(reach.high, high);
  };
  for (const Stretch& s : own.taken) {
    if (s.link == arm.link) include(s.low, s.high);
  }
  for (const Bearing& b : own.bearings) {
    if (b.child == arm.link) include(b.at, b.at);
  }
  return reach;
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
      count += s.link >= 0 && s.link != arm.link && from.overlap(s.low, s.high, near, far);
  }
  double low = arm.at - to.width() / 2;
  double high = arm.at + to.width() / 2;
  if (const auto wheels = to.wheelsOf(arm.child)) {
    low = std::min(low, wheels->low);
    high = std::max(high, wheels->high);
  }
  if (const auto meeting = crossingOf(arm.from, arm.to)) {
    constexpr int kThrough = 6;  // places in gears that shafts through each other weigh as much as
    const Stretch own = reachOf(arm);
    const bool through = from.isBelow(own.low, meeting->first) && from.isBelow(meeting->first, own.high) &&
                         to.isBelow(low, meeting->second) && to.isBelow(meeting->second, high);
    count += through ? kThrough : 0;
  }
  const double reach = kShaftRadius * to.module + 0.5 * from.width();
  const double sine = std::max(from.direction.cross(to.direction).norm(), 0.1);
  const double postEnd = (reach + 0.5 * to.module) / sine;  // nearer to the shaft the post does not come
  const auto isInShaft = [&](const Vector3d& p) {
    const double along = to.coordinate(p);
    return to.isBelow(low, along) && to.isBelow(along, high) && to.isBelow((p - to.at(along)).norm(), reach);
  };
  constexpr int kPlaces = 24;
  for (int i = 1; i <= kPlaces; ++i) {
    const double part = static_cast<double>(i) / kPlaces;
    const Vector3d onPost = end + part * (foot - end);
    const bool inBearing = !to.isBelow(to.width() / 2, std::abs(to.coordinate(onPost) - arm.at)) ||
                           to.isBelow((onPost - end).norm(), postEnd);
    count += isInShaft(start + part * (foot - start)) ? 1 : 0;
    count += !inBearing && isInShaft(onPost) ? 1 : 0;
  }
  return count;
}

/// Would the link's shaft run within that of another on its axis, to the level beyond it, while that one runs
/// within the link's own wheels?
bool BodyPlanner::isAround(int home, int link, double level) const {
  const AxisLayout& own = axis(home);
  const auto wheels = own.wheelsOf(link);
  return wheels && std::any_of(own.bearings.begin(), own.bearings.end(), [&](const Bearing& other) {
           const auto passed = own.wheelsOf(other.child);
           if (other.child == link || !passed) return false;
           const double low = std::min(passed->low, other.at), high = std::max(passed->high, other.at);
           return own.overlap(wheels->low, wheels->high, low, high) &&
                  (own.isBelow(level, low) || own.isBelow(high, level));
         });
}

/// The bearing of the one shaft that an eye at the crossing holds: the one with wheels on both sides of it;
/// where several have theirs on one side, the nearest, on which the others run. The end: there is none.
std::vector<Bearing>::iterator BodyPlanner::heldByTee(int link, int axisClass, double at) {
  AxisLayout& target = axis(axisClass);
  std::vector<std::vector<Bearing>::iterator> passing, below, above;
  const auto none = target.bearings.end();
  for (auto b = target.bearings.begin(); b != none; ++b) {
    const auto wheels = target.wheelsOf(b->child);
    if (b->parent != link || b->placed) continue;
    if (!wheels) return none;
    const bool isPassing = target.isBelow(wheels->low, at) && target.isBelow(at, wheels->high);
    (isPassing ? passing : target.isBelow(at, wheels->high) ? above : below).push_back(b);
  }
  if (passing.size() == 1) return passing.front();
  if (!passing.empty() || below.empty() == above.empty() || below.size() + above.size() < 2) return none;
  const auto away = [&](const auto& b) {
    const auto wheels = target.wheelsOf(b->child);
    return std::max(wheels->low - at, at - wheels->high);
  };
  const auto& all = below.empty() ? above : below;
  return *std::min_element(all.begin(), all.end(),
                           [&](const auto& x, const auto& y) { return target.isBelow(away(x), away(y)); });
}

/// Where axes meet, the link's own shaft can end in an eye about the shaft that passes the crossing or begins
/// there. Whatever else turns there on the link runs on the shaft that it encloses.
bool BodyPlanner::placeTee(int link, int home, int axisClass) {
  AxisLayout& own = axis(home);
  AxisLayout& target = axis(axisClass);
  const auto meeting = crossingOf(home, axisClass);
  if (link == 0 || !meeting) return false;
  const auto [level, at] = *meeting;
  const auto isOthers = [&](const Stretch& s, double low, double high) {
    return s.link >= 0 && own.overlap(s.low, s.high, low, high);
  };
  const double half = target.width() / 2 + target.gap() / 2;
  const double reach = (kShaftRadius + 1.5) * own.module;
  for (const Stretch& s : target.taken) {
    if (isOthers(s, at - half, at + half)) return false;
  }
  for (const Stretch& s : own.taken) {
    if (isOthers(s, level - reach, level + reach)) return false;
    if (s.link == link && own.isBelow(s.low, level) && own.isBelow(level, s.high)) return false;
  }
  if (isAround(home, link, level)) return false;
  const auto through = heldByTee(link, axisClass, at);
  if (through == target.bearings.end()) return false;
  TeePlan tee{link, home, level, axisClass, at, through->child, at, at};
  for (const Bearing& b : target.bearings) {  // what runs on the shaft stands on one side
    const auto wheels = target.wheelsOf(b.child);
    if (&b == &*through || b.parent != link) continue;
    if (!wheels || b.placed) return false;
    if (target.isBelow(wheels->low, at) && target.isBelow(at, wheels->high)) return false;
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
      ShaftSegment& shaft = m_plan.shafts[s];
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
  const int c = classOf(bearing);
  const AxisLayout& own = axis(home);
  const AxisLayout& target = axis(c);
  const auto wheels = target.wheelsOf(bearing.child);
  const auto meeting = crossingOf(home, c);
  if (!wheels || !meeting) return std::nullopt;
  PinPlan pin{link, home, meeting->first, c};
  pin.from = meeting->second;
  if (target.isBelow(wheels->low, pin.from) && target.isBelow(pin.from, wheels->high)) return std::nullopt;
  const double end = 2 * target.gap();
  pin.to = target.isBelow(wheels->low, pin.from) ? wheels->low - end : wheels->high + end;
  const auto inTheWay = [&](const Stretch& s) {
    return s.link >= 0 && s.link != bearing.child &&
           target.overlap(s.low, s.high, std::min(pin.from, pin.to), std::max(pin.from, pin.to));
  };
  if (std::any_of(target.taken.begin(), target.taken.end(), inTheWay)) return std::nullopt;
  for (const Bearing& other : own.bearings) {  // shafts of others through the crossing
    if (other.child == link || !other.isEye()) continue;
    const auto span = own.wheelsOf(other.child);
    const double low = std::min(other.at, span ? span->low : other.at);
    const double high = std::max(other.at, span ? span->high : other.at);
    if (own.isBelow(low, pin.level) && own.isBelow(pin.level, high)) return std::nullopt;
  }
  return pin;
}

/// Levels beside the link's own wheel and arms, or outside of everything.
std::vector<double> BodyPlanner::levelsBeside(int link, int home) const {
  const AxisLayout& own = axis(home);
  std::vector<double> levels{own.outerSlot()};
  const double reach = own.gap() + own.width() / 2;
  for (const Stretch& s : own.taken) {
    if (s.link != link) continue;
    levels.push_back(s.high + reach);
    levels.push_back(s.low - reach);
  }
  if (levels.size() == 1) levels = own.slotCandidates();
  return levels;
}

/// Levels beyond the wheels on an axis that crosses, so that an arm goes round them.
std::vector<double> BodyPlanner::levelsBeyond(int home, int axisClass) const {
  const AxisLayout& own = axis(home);
  std::vector<double> levels;
  for (const std::size_t g : m_gearsOn[static_cast<std::size_t>(axisClass)]) {
    const TrainGear& gear = m_train.gears[g];
    const double beyond = nominalTipRadius(gear.spec) + own.width() / 2 + own.gap();
    const double middle = own.coordinate(gear.pose.translation());
    levels.insert(levels.end(), {middle + beyond, middle - beyond});
  }
  return levels;
}

/// The arm to the bearing's axis that passes most, then the shortest.
BodyPlanner::TriedArm BodyPlanner::bestArm(int link, int home, const Bearing& bearing,
                                           const std::vector<double>& levels) const {
  const int c = classOf(bearing);
  const AxisLayout& target = axis(c);
  const AxisLayout& own = axis(home);
  std::vector<double> places{bearing.at, target.outerSlot()};
  for (const double x : target.slotCandidates()) places.push_back(x);
  TriedArm best;
  double bestCost = 1e300;
  const auto consider = [&](double at, double level, double extra) {
    const ArmPlan arm{link, home, level, c, at, bearing.child};
    constexpr int kInside = 20;  // an arm that cannot come out weighs as much as so many places in gears
    const int hits = armHits(arm) + (own.emerges(link, level) ? 0 : kInside);
    const double cost = 100 * own.module * hits + std::abs(at - bearing.at) +
                        std::abs(level - own.coordinate(target.at(at))) + extra;
    if (cost >= bestCost - 1e-9 * own.module) return;
    best = {arm, hits};
    bestCost = cost;
  };
  for (const double at : places) {
    if (isStopped()) break;
    if (!target.slotIsFree(at)) continue;
    for (const std::size_t a : m_armsOf[static_cast<std::size_t>(link)])
      consider(at, m_plan.arms[a].level, 0);
    for (const double level : levels) {
      if (own.slotIsFree(level)) consider(at, level, 6 * own.module);
    }
  }
  return best;
}

/// Bearing and arm for an axis that crosses the link's own. Bearings go where they are drawn if that is free,
/// arms beside the link's own wheel or where it has one already; but first of all where they pass the gears.
/// Where none does, a pin may, or an arm round the wheels.
void BodyPlanner::placeCrossing(int link, int home, Bearing& bearing) {
  if (m_tries.onFeet.contains(bearing.child) && link == 0) return boltDownOrSay(bearing);
  TriedArm best = bestArm(link, home, bearing, levelsBeside(link, home));
  if (const auto place = best.hits > 0 && link == 0 ? boltPlace(bearing) : std::nullopt)
    return boltDown(bearing, *place);
  bearing.placed = true;
  if (const auto pin = best.hits > 0 ? pinFor(link, home, bearing) : std::nullopt) {
    bearing.form = BearingForm::pin;
    bearing.at = pin->to;
    m_plan.pins.push_back(*pin);
    return;
  }
  const int c = classOf(bearing);
  if (best.hits > 0) {
    const TriedArm other = bestArm(link, home, bearing, levelsBeyond(home, c));
    if (other.hits < best.hits) best = other;
  }
  if (best.hits > 0) m_plan.blocked.push_back({link, bearing.child});
  bearing.at = best.arm.at;
  axis(c).take(best.arm.at, link);
  const auto& arms = m_armsOf[static_cast<std::size_t>(link)];
  const bool stands = std::any_of(arms.begin(), arms.end(),
                                  [&](std::size_t a) { return m_plan.arms[a].level == best.arm.level; });
  if (!stands) axis(home).take(best.arm.level, link);
  addArm(best.arm);
}

}  // namespace geargraph::inline arrangement
