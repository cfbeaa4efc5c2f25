#include "core/gears/body_plan.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/gears/coaxial_plan.h"
#include "core/gears/coaxial_sections.h"
#include "core/gears/gear_body.h"
#include "core/gears/gear_obstacles.h"
#include "core/gears/train_wheels.h"

namespace geargraph {
namespace {

using Eigen::Vector3d;

constexpr double kShaftRadius = 1.8;  // modules, where bores leave room for it

class Planner {
 public:
  Planner(const Mechanism& mechanism, const Placement& placement, const GearTrain& train)
      : m_placement(placement), m_tree(*placement.tree), m_train(train), m_obstacles(train) {
    m_plan.axes = axisLayouts(mechanism, placement, train);
    m_plan.shaftsOn.resize(m_plan.axes.size());
    m_gearsOn.resize(m_plan.axes.size());
    m_coaxial.resize(m_plan.axes.size(), false);
    m_heldBy.resize(mechanism.links.size());
    m_armsOf.resize(mechanism.links.size());
    for (std::size_t g = 0; g < train.gears.size(); ++g) {
      m_gearsOn[static_cast<std::size_t>(train.gears[g].axisClass)].push_back(g);
    }
    for (std::size_t c = 0; c < m_plan.axes.size(); ++c) {
      for (std::size_t b = 0; b < m_plan.axes[c].bearings.size(); ++b) {
        m_heldBy[static_cast<std::size_t>(m_plan.axes[c].bearings[b].parent)].push_back(
            {static_cast<int>(c), b});
      }
    }
  }

  BodyPlan plan() {
    for (std::size_t c = 0; c < m_plan.axes.size(); ++c) planCoaxial(static_cast<int>(c));
    placeCups();
    const std::vector<int> links = m_tree.breadthFirst();
    for (const int link : links) placeLink(link);
    for (const int link : links) {
      if (link == 0) continue;
      const int c = m_placement.classes->classOfLink(m_tree, link);
      if (!isCoaxial(c)) addShaft(c, link);
    }
    addFixedHubs();
    for (const PinPlan& pin : m_plan.pins) addShaft(pin.axisClass, pin.link);
    for (std::size_t c = 0; c < m_plan.axes.size(); ++c) {
      if (!isCoaxial(static_cast<int>(c))) nestShafts(static_cast<int>(c));
    }
    trimTees();
    return std::move(m_plan);
  }

 private:
  void planCoaxial(int axisClass);
  [[nodiscard]] bool isCoaxial(int axisClass) const { return m_coaxial[static_cast<std::size_t>(axisClass)]; }
  void placeCups();
  void placeLink(int link);
  void placeParallel(int link, int home, const std::vector<Bearing*>& round);
  void placeCrossing(int link, int home, Bearing& bearing);
  [[nodiscard]] int armHits(const ArmPlan& arm) const;
  [[nodiscard]] double commonLevel(int link, int home, const std::vector<Bearing*>& round);
  [[nodiscard]] bool fits(int home, const std::vector<Bearing*>& round, double level) const;
  [[nodiscard]] int shaftHits(const ArmPlan& arm) const;
  bool placeTee(int link, int home, int axisClass);
  void trimTees();
  [[nodiscard]] std::optional<PinPlan> pinFor(int link, int home, const Bearing& bearing) const;
  [[nodiscard]] std::vector<std::vector<Bearing*>> roundsOf(int link, int home);
  void addShaft(int axisClass, int link);
  void addArm(const ArmPlan& arm) {
    m_armsOf[static_cast<std::size_t>(arm.link)].push_back(m_plan.arms.size());
    m_plan.arms.push_back(arm);
  }
  [[nodiscard]] std::optional<double> heldLevel(int axisClass, int link) const;
  void addFixedHubs();
  void nestShafts(int axisClass);
  [[nodiscard]] double boreRoom(int axisClass, int link) const;

  AxisLayout& axis(int c) { return m_plan.axes[static_cast<std::size_t>(c)]; }
  [[nodiscard]] const AxisLayout& axis(int c) const { return m_plan.axes[static_cast<std::size_t>(c)]; }
  [[nodiscard]] bool parallel(int a, int b) const {
    return axis(a).direction.cross(axis(b).direction).norm() < 1e-6;
  }
  /// Coordinate along class b of the plane through coordinate x of a parallel class a.
  [[nodiscard]] double carried(int a, double x, int b) const { return axis(b).coordinate(axis(a).at(x)); }

  const Placement& m_placement;
  const JointTree& m_tree;
  const GearTrain& m_train;
  GearObstacles m_obstacles;
  std::vector<std::vector<std::size_t>> m_gearsOn;  ///< gears by axis class
  std::vector<bool> m_coaxial;                      ///< axis classes that have a plan of their own
  std::vector<std::vector<std::pair<int, std::size_t>>>
      m_heldBy;                                    ///< bearings (class, place) by the link that holds
  std::vector<std::vector<std::size_t>> m_armsOf;  ///< arms by link
  BodyPlan m_plan;
};

/// Linked sets: sleeves, discs and drums of one axis, with the bearings and arms on it.
void Planner::planCoaxial(int axisClass) {
  if (!needsCoaxialPlan(axisClass, m_placement, m_train)) return;
  const auto plan = coaxialPlan(axisClass, m_plan.axes, m_placement, m_train);
  if (!plan) {
    m_plan.blocked.emplace_back();
    for (const Bearing& b : axis(axisClass).bearings) m_plan.blocked.back().push_back(b.child);
    return;
  }
  m_coaxial[static_cast<std::size_t>(axisClass)] = true;
  axis(axisClass).thickness = plan->width;
  for (const CoaxialBearing& placed : plan->bearings) {
    const int c = m_placement.classes->classOf[static_cast<std::size_t>(placed.joint)];
    axis(c).thickness = plan->width;
    for (Bearing& b : axis(c).bearings) {
      if (b.joint != placed.joint) continue;
      b.at = placed.at;
      b.form = placed.form;
      b.placed = true;
    }
  }
  for (const ShaftPlan& shaft : plan->shafts) {
    m_plan.shaftsOn[static_cast<std::size_t>(axisClass)].push_back(m_plan.shafts.size());
    m_plan.shafts.push_back(shaft);
  }
  for (const ArmPlan& arm : plan->arms) addArm(arm);
  m_plan.pins.insert(m_plan.pins.end(), plan->pins.begin(), plan->pins.end());
  m_plan.lathes.insert(m_plan.lathes.end(), plan->lathes.begin(), plan->lathes.end());
  m_plan.cages.insert(m_plan.cages.end(), plan->cages.begin(), plan->cages.end());
  m_plan.hubs.insert(m_plan.hubs.end(), plan->hubs.begin(), plan->hubs.end());
}

/// Rings get the face on the bearing side, so that carriers find the other one free.
void Planner::placeCups() {
  for (std::size_t g = 0; g < m_train.gears.size(); ++g) {
    const TrainGear& gear = m_train.gears[g];
    if (gear.spec.kind != GearKind::internal || isCoaxial(gear.axisClass)) continue;
    AxisLayout& layout = axis(gear.axisClass);
    const double middle = layout.coordinate(gear.pose.translation());
    const double reach = gear.spec.faceWidth / 2 + layout.gap() + layout.width() / 2;
    int side = layout.bearingSide;
    if (!layout.slotIsFree(middle + side * reach)) side = -side;
    m_plan.cups.push_back({static_cast<int>(g), side, middle + side * reach});
    layout.take(middle + side * reach, gear.link);
  }
}

/// The bearings that a link holds, a round at a time: one of each axis parallel to its own (its own
/// included), those whose wheels are nearest the bearings' end first.
std::vector<std::vector<Bearing*>> Planner::roundsOf(int link, int home) {
  std::vector<std::vector<Bearing*>> rounds;
  const auto& held = m_heldBy[static_cast<std::size_t>(link)];
  for (std::size_t first = 0; first < held.size();) {
    const int c = held[first].first;
    AxisLayout& layout = axis(c);
    std::vector<Bearing*> here;
    for (; first < held.size() && held[first].first == c; ++first) {
      Bearing& bearing = layout.bearings[held[first].second];
      if (!bearing.placed) here.push_back(&bearing);
    }
    if (!parallel(home, c)) continue;
    const auto depth = [&](const Bearing* b) {
      double nearest = -1e300;                 // a link without wheels has the inmost shaft
      for (const Stretch& s : layout.taken) {  // wheels and cups
        if (s.link == b->child) nearest = std::max(nearest, layout.bearingSide * (s.low + s.high) / 2);
      }
      return nearest;
    };
    std::stable_sort(here.begin(), here.end(),
                     [&](const Bearing* x, const Bearing* y) { return depth(x) > depth(y); });
    for (std::size_t i = 0; i < here.size(); ++i) {
      if (rounds.size() <= i) rounds.emplace_back();
      rounds[i].push_back(here[i]);
    }
  }
  return rounds;
}

void Planner::placeLink(int link) {
  const auto& held = m_heldBy[static_cast<std::size_t>(link)];
  if (held.empty()) return;
  int home = m_placement.classes->classOfLink(m_tree, link);
  if (home < 0) home = held.back().first;  // the ground: the last of its axes
  for (const auto& round : roundsOf(link, home)) placeParallel(link, home, round);
  for (std::size_t i = 0; i < held.size(); ++i) {
    const int c = held[i].first;
    if (!parallel(home, c) && (i == 0 || held[i - 1].first != c)) placeTee(link, home, c);
  }
  for (const auto& [c, b] : held) {
    if (!parallel(home, c) && !axis(c).bearings[b].placed) placeCrossing(link, home, axis(c).bearings[b]);
  }
}

/// Is a level free on the axes of all these bearings, and can straight arms reach them from the link's own?
bool Planner::fits(int home, const std::vector<Bearing*>& round, double level) const {
  std::vector<int> involved{home};
  for (const Bearing* b : round) {
    involved.push_back(m_placement.classes->classOf[static_cast<std::size_t>(b->joint)]);
    if (!axis(involved.back()).nests(*b, carried(home, level, involved.back()))) return false;
  }
  for (const int c : involved) {
    if (!axis(c).slotIsFree(carried(home, level, c))) return false;
  }
  if (!round.empty() && !axis(home).emerges(round.front()->parent, level)) return false;
  const AxisLayout& own = axis(home);
  const Vector3d start = own.at(level);
  const auto gears = m_obstacles.inPlane(start, own.direction, own.width() / 2 + own.gap() / 2);
  if (gears.empty()) return true;
  return std::all_of(involved.begin(), involved.end(), [&](int c) {
    const Vector3d end = axis(c).at(carried(home, level, c));
    return c == home || m_obstacles.isClear(gears, start, end, 2.5 * own.module);
  });
}

/// A level at which the link's arms lie in one plane, beside the wheels: the free one nearest to what is
/// drawn. The ground stands at the bearings' end, behind everything; carriers keep to the other.
double Planner::commonLevel(int link, int home, const std::vector<Bearing*>& round) {
  const int side = axis(home).bearingSide;
  std::vector<int> involved{home};
  std::vector<double> candidates;
  std::vector<double> edges;  // of what stands on the axes, towards the bearings' end
  for (const Bearing* b : round) {
    const int c = m_placement.classes->classOf[static_cast<std::size_t>(b->joint)];
    if (c != home) involved.push_back(c);
    candidates.push_back(carried(c, b->at, home));
  }
  const double wanted = candidates.front();
  for (const int c : involved) {
    for (const double x : axis(c).slotCandidates()) candidates.push_back(carried(c, x, home));
    for (const Stretch& s : axis(c).taken)
      edges.push_back(side * carried(c, side < 0 ? s.low : s.high, home));
  }
  std::sort(edges.begin(), edges.end());
  const auto cost = [&](double x) {
    double sum = std::abs(x - wanted);
    if (link == 0 && x != wanted) {
      const auto beyond = edges.end() - std::upper_bound(edges.begin(), edges.end(), side * x);
      sum += 1000 * axis(home).module * static_cast<double>(beyond);
    } else if (side * (x - wanted) > 0) {
      sum += 2 * axis(home).module;
    }
    return sum;
  };
  std::sort(candidates.begin(), candidates.end(), [&](double a, double b) { return cost(a) < cost(b); });
  const auto same = [&](double a, double b) { return std::abs(a - b) < 1e-6 * axis(home).module; };
  candidates.erase(std::unique(candidates.begin(), candidates.end(), same), candidates.end());
  constexpr std::size_t kTries = 40;
  for (std::size_t i = 0; i < std::min(candidates.size(), kTries); ++i) {
    if (fits(home, round, candidates[i])) return candidates[i];
  }
  m_plan.blocked.push_back({link});
  for (const Bearing* b : round) m_plan.blocked.back().push_back(b->child);
  const auto outmost = std::max_element(candidates.begin(), candidates.end(),
                                        [&](double a, double b) { return side * a < side * b; });
  return *outmost;
}

void Planner::placeParallel(int link, int home, const std::vector<Bearing*>& round) {
  const double level = commonLevel(link, home, round);
  axis(home).take(level, link);
  for (Bearing* b : round) {
    const int c = m_placement.classes->classOf[static_cast<std::size_t>(b->joint)];
    b->at = carried(home, level, c);
    b->placed = true;
    if (c == home) continue;
    axis(c).take(b->at, link);
    addArm({link, home, level, c, b->at, b->child});
  }
}

/// How many places of an arm with its post lie in gears of other links.
int Planner::armHits(const ArmPlan& arm) const {
  const AxisLayout& from = axis(arm.from);
  const Vector3d start = from.at(arm.level);
  const Vector3d end = axis(arm.to).at(arm.at);
  const Vector3d foot = end - (end - start).dot(from.direction) * from.direction;
  const double margin = 0.5 * from.width() + 0.3 * from.module;
  return m_obstacles.hits(arm.link, start, foot, margin) + m_obstacles.hits(arm.link, end, foot, margin) +
         shaftHits(arm);
}

/// How many places of an arm with its post lie in the shaft that its bearing holds, outside of the bearing.
int Planner::shaftHits(const ArmPlan& arm) const {
  const AxisLayout& from = axis(arm.from);
  const AxisLayout& to = axis(arm.to);
  const Vector3d start = from.at(arm.level);
  const Vector3d end = to.at(arm.at);
  const Vector3d foot = end - (end - start).dot(from.direction) * from.direction;
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
  int count = 0;
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
bool Planner::placeTee(int link, int home, int axisClass) {
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
void Planner::trimTees() {
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
std::optional<PinPlan> Planner::pinFor(int link, int home, const Bearing& bearing) const {
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
void Planner::placeCrossing(int link, int home, Bearing& bearing) {
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

/// A frame has no shaft of its own: its arms begin about the shaft of the one link that it holds on their
/// axis, where nobody else's wheels are in between.
std::optional<double> Planner::heldLevel(int axisClass, int link) const {
  const AxisLayout& layout = axis(axisClass);
  if (layout.bearings.size() != 1 || layout.bearings.front().child != link) return std::nullopt;
  const Bearing& bearing = layout.bearings.front();
  if (bearing.parent != 0) return std::nullopt;
  for (const std::size_t a : m_armsOf[0]) {
    const ArmPlan& arm = m_plan.arms[a];
    if (arm.from != axisClass || arm.level == bearing.at) continue;
    const double low = std::min(arm.level, bearing.at);
    const double high = std::max(arm.level, bearing.at);
    const bool blocked = std::any_of(layout.taken.begin(), layout.taken.end(), [&](const Stretch& s) {
      return s.link != link && s.link != 0 && s.low < high && s.high > low;
    });
    if (!blocked) return arm.level;
  }
  return std::nullopt;
}

/// A shaft reaches from the link's wheels to its bearing, its arms and cups on this axis.
void Planner::addShaft(int axisClass, int link) {
  const AxisLayout& layout = axis(axisClass);
  ShaftPlan shaft;
  shaft.axisClass = axisClass;
  shaft.link = link;
  const double half = layout.width() / 2;
  const bool turns = m_placement.classes->classOfLink(m_tree, link) == axisClass;
  for (const std::size_t g : m_gearsOn[static_cast<std::size_t>(axisClass)]) {
    const TrainGear& gear = m_train.gears[g];
    if (gear.link != link || gear.spec.kind == GearKind::internal) continue;
    const AxialSpan hub = hubSpan(gear.spec);
    const double sense = gear.pose.linear().col(2).dot(layout.direction) < 0 ? -1 : 1;
    const double origin = layout.coordinate(gear.pose.translation());
    for (const double z : {hub.low, hub.high}) shaft.include(origin + sense * z, origin + sense * z);
  }
  for (const std::size_t a : m_armsOf[static_cast<std::size_t>(link)]) {
    const ArmPlan& arm = m_plan.arms[a];
    if (arm.from == axisClass) shaft.include(arm.level - half, arm.level + half);
  }
  if (const auto level = heldLevel(axisClass, link)) shaft.include(*level - half, *level + half);
  for (const CupPlan& cup : m_plan.cups) {
    const TrainGear& gear = m_train.gears[static_cast<std::size_t>(cup.gear)];
    if (gear.link == link && gear.axisClass == axisClass) shaft.include(cup.plate - half, cup.plate + half);
  }
  for (const TeePlan& tee : m_plan.tees) {
    if (tee.link == link && tee.home == axisClass) shaft.include(tee.level, tee.level);
    if (tee.child == link && tee.axisClass == axisClass) shaft.include(tee.low, tee.high);
  }
  for (const PinPlan& pin : m_plan.pins) {
    if (pin.link == link && pin.home == axisClass) shaft.include(pin.level, pin.level);
    if (pin.link == link && pin.axisClass == axisClass)
      shaft.include(std::min(pin.from, pin.to), std::max(pin.from, pin.to));
  }
  const Bearing* nearest = nullptr;  // what holds a wheel that does not turn here
  const auto away = [&](const Bearing& b) { return std::max({b.at - shaft.high, shaft.low - b.at, 0.0}); };
  for (const Bearing& b : layout.bearings) {
    if (!b.isEye()) continue;
    if (b.parent == link && (nearest == nullptr || away(b) < away(*nearest))) nearest = &b;
    if (turns && (b.child == link || b.parent == link)) shaft.include(b.at - half, b.at + half);
  }
  if (!turns && nearest != nullptr) shaft.include(nearest->at - half, nearest->at + half);
  if (shaft.low < shaft.high) {
    shaft.low -= 0.4 * layout.gap();  // neighbours do not touch
    shaft.high += 0.4 * layout.gap();
    m_plan.shaftsOn[static_cast<std::size_t>(axisClass)].push_back(m_plan.shafts.size());
    m_plan.shafts.push_back(shaft);
  }
}

/// Wheels that stand on an axis without turning about it are held by the bearings that their link has there,
/// rings by the tube between their cup and these.
void Planner::addFixedHubs() {
  for (const TrainGear& gear : m_train.gears) {
    const bool turns = m_placement.classes->classOfLink(m_tree, gear.link) == gear.axisClass;
    if (turns || isCoaxial(gear.axisClass)) continue;
    if (m_plan.shaftOf(gear.axisClass, gear.link, 0) == nullptr) addShaft(gear.axisClass, gear.link);
  }
}

/// Largest radius that the bores of the link's wheels on this axis allow.
double Planner::boreRoom(int axisClass, int link) const {
  double room = 1e300;
  for (const std::size_t g : m_gearsOn[static_cast<std::size_t>(axisClass)]) {
    const TrainGear& gear = m_train.gears[g];
    if (gear.link != link || gear.spec.kind == GearKind::internal) continue;
    room = std::min(room, shaftRoom(gear.spec));
  }
  return room;
}

/// Shafts that lie over each other are nested, the longest inmost; all of an axis shrink together until the
/// bores of their wheels hold them.
void Planner::nestShafts(int axisClass) {
  std::vector<ShaftPlan*> shafts;
  for (const std::size_t s : m_plan.shaftsOn[static_cast<std::size_t>(axisClass)]) {
    shafts.push_back(&m_plan.shafts[s]);
  }
  std::stable_sort(shafts.begin(), shafts.end(), [](const ShaftPlan* a, const ShaftPlan* b) {
    return a->high - a->low > b->high - b->low;
  });
  const double module = axis(axisClass).module;
  double scale = 1;
  for (std::size_t i = 0; i < shafts.size(); ++i) {
    ShaftPlan& shaft = *shafts[i];
    double inside = 0;
    for (std::size_t k = 0; k < i; ++k) {
      const bool over = shafts[k]->low < shaft.high && shaft.low < shafts[k]->high;
      if (over) inside = std::max(inside, shafts[k]->outer);
    }
    shaft.inner = inside > 0 ? inside + 0.12 * module : 0;
    shaft.outer = inside > 0 ? inside + 1.0 * module : kShaftRadius * module;
    scale = std::min(scale, boreRoom(axisClass, shaft.link) / shaft.outer);
  }
  for (ShaftPlan* shaft : shafts) {
    shaft->inner *= scale;
    shaft->outer *= scale;
  }
}

}  // namespace

BodyPlan planBodies(const Mechanism& mechanism, const Placement& placement, const GearTrain& train) {
  return Planner(mechanism, placement, train).plan();
}

}  // namespace geargraph
