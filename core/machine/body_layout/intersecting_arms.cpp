#include "core/machine/body_layout/intersecting_arms.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "core/machine/body_layout/body_shapes.h"
#include "core/machine/body_layout/pedestals.h"
#include "core/machine/solids/gear_body.h"

namespace geargraph {

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

/// How many shafts that other arms of the link hold stand in the way of a bar in the plane of these arms.
int heldInTheWay(const PlanDraft& draft, const ArmPlan& arm) {
  const AxisLayout& from = draft.axis(arm.from);
  const auto [start, foot, end] = linesOf(from, draft.axis(arm.to), arm);
  const Vector3d bar = foot - start;
  if (bar.norm() < from.module) return 0;
  const double reach = kShaftRadius * from.module + 0.5 * from.width();
  const auto& arms = draft.armsOf[arm.link];
  return static_cast<int>(std::count_if(arms.begin(), arms.end(), [&](std::size_t a) {
    const ArmPlan& other = draft.plan.arms[a];
    if (other.from != arm.from || !draft.parallel(arm.from, other.to) ||
        !from.isBelow(std::abs(other.level - arm.level), from.width()))
      return false;
    const Vector3d held = draft.axis(other.to).at(draft.carried(arm.from, arm.level, other.to)) - start;
    const double part = std::clamp(held.dot(bar) / bar.squaredNorm(), 0.0, 1.0);
    return from.isBelow((held - part * bar).norm(), reach);
  }));
}

/// How many places of an arm with its standoff lie in gears of other links.
int armCollisions(const PlanDraft& draft, const ArmPlan& arm) {
  const AxisLayout& from = draft.axis(arm.from);
  const auto [start, foot, end] = linesOf(from, draft.axis(arm.to), arm);
  const double margin = 0.5 * from.width() + 0.3 * from.module;
  return draft.obstacles.collisions(arm.link, start, foot, margin) +
         draft.obstacles.collisions(arm.link, end, foot, margin) + shaftCollisions(draft, arm) +
         heldInTheWay(draft, arm);
}

/// Levels beside the link's own wheel and arms, or outside of everything.
std::vector<double> levelsBeside(const PlanDraft& draft, LinkOrdinal link, AxisGroupOrdinal home) {
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
std::vector<double> levelsBeyond(const PlanDraft& draft, AxisGroupOrdinal home, AxisGroupOrdinal axisGroup) {
  const AxisLayout& own = draft.axis(home);
  std::vector<double> levels;
  for (const GearOrdinal g : draft.gearsOn[axisGroup]) {
    const TrainGear& gear = draft.train.gears[g];
    const double beyond = nominalTipRadius(gear.spec) + own.width() / 2 + own.gap();
    const double middle = own.coordinate(gear.pose.translation());
    levels.insert(levels.end(), {middle + beyond, middle - beyond});
  }
  return levels;
}

/// Where a bearing may be on its axis.
std::vector<double> placesOf(const PlanDraft& draft, const Bearing& bearing) {
  const AxisLayout& on = draft.axis(draft.classOf(bearing));
  std::vector<double> places{bearing.at, on.outerSlot()};
  for (const double x : on.slotCandidates()) places.push_back(x);
  std::erase_if(places, [&](double at) { return !on.slotIsFree(at); });
  return places;
}

/// Which arms to an axis make a fork: two from one bar, on both sides of the link's own axis.
class Forks {
 public:
  Forks(const PlanDraft& draft, LinkOrdinal link, AxisGroupOrdinal home, const Bearing& bearing)
      : m_draft(draft), m_link(link), m_home(home), m_to(draft.classOf(bearing)) {
    const auto intersection = draft.intersectionOf(home, m_to);
    if (!intersection) return;
    m_middle = intersection->second;
    for (const Bearing& other : draft.axis(m_to).bearings) {
      const bool isAcross = side(other.at) * side(bearing.at) < 0;
      if (other.parent == link && other.child != bearing.child && !other.placed && isAcross) m_other = &other;
    }
  }

  /// With an arm that is there, or with one that can be.
  [[nodiscard]] bool contain(const ArmPlan& arm) {
    if (!m_middle) return false;
    const auto& arms = m_draft.armsOf[m_link];
    const bool isThere = std::any_of(arms.begin(), arms.end(), [&](std::size_t a) {
      const ArmPlan& other = m_draft.plan.arms[a];
      return other.to == m_to && other.level == arm.level && side(other.at) * side(arm.at) < 0;
    });
    return isThere || (m_other != nullptr && side(m_other->at) * side(arm.at) < 0 && canBe(arm.level));
  }

 private:
  [[nodiscard]] int side(double at) const { return at < *m_middle ? -1 : 1; }

  [[nodiscard]] bool canBe(double level) {
    const auto known = m_known.find(level);
    if (known != m_known.end()) return known->second;
    const std::vector<double> places = placesOf(m_draft, *m_other);
    const bool can = std::any_of(places.begin(), places.end(), [&](double at) {
      return side(at) == side(m_other->at) &&
             armCollisions(m_draft, {m_link, m_home, level, m_to, at, m_other->child}) == 0;
    });
    m_known.emplace(level, can);
    return can;
  }

  const PlanDraft& m_draft;
  LinkOrdinal m_link;
  AxisGroupOrdinal m_home, m_to;
  std::optional<double> m_middle;    ///< of the intersection, along the other axis
  const Bearing* m_other = nullptr;  ///< a bearing across that has no arm yet
  std::map<double, bool> m_known;    ///< by level
};

/// The arm to the bearing's axis that passes most, then one that makes a fork, then the shortest.
TriedArm bestArm(const PlanDraft& draft, LinkOrdinal link, AxisGroupOrdinal home, const Bearing& bearing,
                 const std::vector<double>& levels) {
  const int c = draft.classOf(bearing);
  const AxisLayout& target = draft.axis(c);
  const AxisLayout& own = draft.axis(home);
  Forks forks(draft, link, home, bearing);
  TriedArm best;
  double bestCost = 1e300;
  const auto consider = [&](double at, double level, double extra) {
    const ArmPlan arm{link, home, level, c, at, bearing.child};
    constexpr double kNoFork = 60;  // modules that a fork may be longer; less than one place in a gear
    constexpr int kInside = 20;     // an arm that cannot come out weighs as much as so many places in gears
    const int collisions = armCollisions(draft, arm) + (own.emerges(link, level) ? 0 : kInside);
    const double length = std::abs(at - bearing.at) + std::abs(level - own.coordinate(target.at(at))) + extra;
    const double cost =
        100 * own.module * collisions + (forks.contain(arm) ? 0 : kNoFork * own.module) + length;
    if (cost >= bestCost - 1e-9 * own.module) return;
    best = {arm, collisions};
    bestCost = cost;
  };
  for (const double at : placesOf(draft, bearing)) {
    if (draft.isStopped()) break;
    for (const std::size_t a : draft.armsOf[link]) consider(at, draft.plan.arms[a].level, 0);
    for (const double level : levels) {
      if (own.slotIsFree(level)) consider(at, level, 6 * own.module);
    }
  }
  return best;
}

}  // namespace

std::optional<PinPlan> pinFor(const PlanDraft& draft, LinkOrdinal link, AxisGroupOrdinal home,
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

void placeIntersecting(PlanDraft& draft, LinkOrdinal link, AxisGroupOrdinal home, Bearing& bearing) {
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

}  // namespace geargraph
