#include "core/gears/body_plan.h"

#include <algorithm>
#include <cmath>

#include "core/gears/gear_body.h"
#include "core/gears/train_wheels.h"

namespace geargraph {
namespace {

using Eigen::Vector3d;

class Planner {
 public:
  Planner(const Mechanism& mechanism, const Placement& placement, const GearTrain& train)
      : m_placement(placement), m_tree(*placement.tree), m_train(train) {
    m_plan.axes = axisLayouts(mechanism, placement, train);
  }

  BodyPlan plan() {
    placeCups();
    for (const int link : m_tree.order) placeLink(link);
    for (const int link : m_tree.order) {
      if (link != 0) addShaft(m_placement.classes->classOfLink(m_tree, link), link);
    }
    addFixedHubs();
    for (std::size_t c = 0; c < m_plan.axes.size(); ++c) nestShafts(static_cast<int>(c));
    return std::move(m_plan);
  }

 private:
  void placeCups();
  void placeLink(int link);
  void placeParallel(int link, int home, const std::vector<Bearing*>& round);
  void placeCrossing(int link, int home, Bearing& bearing);
  [[nodiscard]] int armHits(const ArmPlan& arm) const;
  [[nodiscard]] double commonLevel(int link, int home, const std::vector<Bearing*>& round);
  [[nodiscard]] bool armIsClear(int from, int to, double level) const;
  [[nodiscard]] std::vector<std::vector<Bearing*>> roundsOf(int link, int home);
  void addShaft(int axisClass, int link);
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
  BodyPlan m_plan;
};

/// Rings get the face on the bearing side, so that carriers find the other one free.
void Planner::placeCups() {
  for (std::size_t g = 0; g < m_train.gears.size(); ++g) {
    const TrainGear& gear = m_train.gears[g];
    if (gear.spec.kind != GearKind::internal) continue;
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
  for (std::size_t c = 0; c < m_plan.axes.size(); ++c) {
    AxisLayout& layout = m_plan.axes[c];
    if (!parallel(home, static_cast<int>(c))) continue;
    std::vector<Bearing*> held;
    for (Bearing& b : layout.bearings) {
      if (b.parent == link) held.push_back(&b);
    }
    const auto depth = [&](const Bearing* b) {
      double nearest = -1e300;                 // a link without wheels has the inmost shaft
      for (const Stretch& s : layout.taken) {  // wheels and cups
        if (s.link == b->child) nearest = std::max(nearest, layout.bearingSide * (s.low + s.high) / 2);
      }
      return nearest;
    };
    std::stable_sort(held.begin(), held.end(),
                     [&](const Bearing* a, const Bearing* b) { return depth(a) > depth(b); });
    for (std::size_t i = 0; i < held.size(); ++i) {
      if (rounds.size() <= i) rounds.emplace_back();
      rounds[i].push_back(held[i]);
    }
  }
  return rounds;
}

void Planner::placeLink(int link) {
  const AxisClasses& classes = *m_placement.classes;
  int home = classes.classOfLink(m_tree, link);
  for (std::size_t c = 0; home < 0 && c < m_plan.axes.size(); ++c) {
    for (const Bearing& b : m_plan.axes[c].bearings) {
      if (b.parent == link) home = static_cast<int>(c);
    }
  }
  if (home < 0) return;
  for (const auto& round : roundsOf(link, home)) placeParallel(link, home, round);
  for (std::size_t c = 0; c < m_plan.axes.size(); ++c) {
    if (parallel(home, static_cast<int>(c))) continue;
    for (Bearing& b : m_plan.axes[c].bearings) {
      if (b.parent == link) placeCrossing(link, home, b);
    }
  }
}

/// No wheel stands where a straight arm would pass between two parallel axes.
bool Planner::armIsClear(int from, int to, double level) const {
  const AxisLayout& home = axis(from);
  const Vector3d a = home.at(level);
  const Vector3d b = axis(to).at(carried(from, level, to));
  const double half = home.width() / 2 + home.gap() / 2;
  for (const TrainGear& gear : m_train.gears) {
    const Vector3d k = gear.pose.linear().col(2);
    if (k.cross(home.direction).norm() > 1e-6) continue;
    const AxialSpan span = axialSpan(gear.spec);
    const double along = (a - gear.pose.translation()).dot(k);
    if (along + half < span.low || along - half > span.high) continue;
    const Vector3d centre = gear.pose.translation() + along * k;
    const double part =
        std::clamp((centre - a).dot(b - a) / std::max((b - a).squaredNorm(), 1e-12), 0.0, 1.0);
    const double distance = (centre - a - part * (b - a)).norm();
    if (distance < nominalTipRadius(gear.spec) + 2.5 * home.module) return false;
  }
  return true;
}

/// A level at which the link's arms lie in one plane, beside the wheels.
double Planner::commonLevel(int link, int home, const std::vector<Bearing*>& round) {
  const auto classOf = [&](const Bearing* b) {
    return m_placement.classes->classOf[static_cast<std::size_t>(b->joint)];
  };
  std::vector<double> candidates;
  std::vector<int> involved{home};
  for (const Bearing* b : round) {
    if (classOf(b) != home) involved.push_back(classOf(b));
    candidates.push_back(carried(classOf(b), b->at, home));
  }
  const double wanted = candidates.front();
  for (const int c : involved) {
    for (const double x : axis(c).slotCandidates()) candidates.push_back(carried(c, x, home));
  }
  const int side = axis(home).bearingSide;
  double best = 0;
  double bestCost = 1e300;
  double outmost = side * 1e300 * -1;
  for (const double x : candidates) {
    if (side * x > side * outmost || std::abs(outmost) > 1e299) outmost = x;
    bool fits = true;
    for (const int c : involved) {
      fits = fits && axis(c).slotIsFree(carried(home, x, c)) && (c == home || armIsClear(home, c, x));
    }
    // The ground stands at the bearings' end, behind everything; carriers keep to the other.
    double cost = std::abs(x - wanted);
    if (link == 0 && x != wanted) {
      for (const int c : involved) {
        for (const Stretch& s : axis(c).taken) {
          const double edge = carried(c, side < 0 ? s.low : s.high, home);
          if (side * x < side * edge) cost += 1000 * axis(home).module;
        }
      }
    } else if (side * (x - wanted) > 0) {
      cost += 2 * axis(home).module;
    }
    if (fits && cost < bestCost - 1e-9) {
      best = x;
      bestCost = cost;
    }
  }
  return bestCost < 1e299 ? best : outmost;
}

void Planner::placeParallel(int link, int home, const std::vector<Bearing*>& round) {
  const double level = commonLevel(link, home, round);
  axis(home).take(level, link);
  for (Bearing* b : round) {
    const int c = m_placement.classes->classOf[static_cast<std::size_t>(b->joint)];
    b->at = carried(home, level, c);
    if (c == home) continue;
    axis(c).take(b->at, link);
    m_plan.arms.push_back({link, home, level, c, b->at, b->child});
  }
}

/// Is the point in a gear, or nearer than an arm is wide? Bevels count as what their tips sweep.
bool nearGear(const TrainGear& gear, const Vector3d& p, double margin) {
  const Vector3d local = gear.pose.inverse() * p;
  const AxialSpan span = axialSpan(gear.spec);
  if (local.z() < span.low - margin || local.z() > span.high + margin) return false;
  const double radius = std::hypot(local.x(), local.y());
  if (gear.spec.kind == GearKind::internal) return radius > nominalTipRadius(gear.spec) - margin;
  double reach = nominalTipRadius(gear.spec);
  if (gear.spec.kind == GearKind::bevel && gear.spec.coneAngle < 1.3) {
    const double tip =
        gear.spec.coneAngle + (gear.spec.addendum + 0.5) * gear.spec.module / coneDistance(gear.spec);
    reach = std::min(reach, std::max(local.z(), 0.0) * std::tan(tip));
  }
  return radius < reach + margin;
}

/// How many places of an arm with its post and bearing lie in gears of other links.
int Planner::armHits(const ArmPlan& arm) const {
  const AxisLayout& from = axis(arm.from);
  const Vector3d start = from.at(arm.level);
  const Vector3d end = axis(arm.to).at(arm.at);
  const Vector3d foot = end - (end - start).dot(from.direction) * from.direction;
  const double margin = 0.5 * from.width() + 0.3 * from.module;
  constexpr int kPlaces = 12;
  int hits = 0;
  for (const TrainGear& gear : m_train.gears) {
    if (gear.link == arm.link) continue;
    for (int i = 0; i <= kPlaces; ++i) {
      const double part = static_cast<double>(i) / kPlaces;
      hits += nearGear(gear, start + part * (foot - start), margin) && i > 0 ? 1 : 0;
      hits += nearGear(gear, foot + part * (end - foot), margin) && i < kPlaces ? 1 : 0;
    }
  }
  return hits;
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
  for (const ArmPlan& arm : m_plan.arms) {
    if (arm.link == link && arm.from == home) standing.push_back(arm.level);
  }
  ArmPlan best;
  double bestCost = 1e300;
  const auto consider = [&](double at, double level, double extra) {
    const ArmPlan arm{link, home, level, c, at, bearing.child};
    const double cost = 100 * own.module * armHits(arm) + std::abs(at - bearing.at) +
                        std::abs(level - own.coordinate(target.at(at))) + extra;
    if (cost < bestCost - 1e-9) {
      best = arm;
      bestCost = cost;
    }
  };
  for (const double at : places) {
    if (!target.slotIsFree(at)) continue;
    for (const double level : standing) consider(at, level, 0);
    for (const double level : levels) {
      if (own.slotIsFree(level)) consider(at, level, 6 * own.module);
    }
  }
  bearing.at = best.at;
  target.take(best.at, link);
  if (std::find(standing.begin(), standing.end(), best.level) == standing.end()) own.take(best.level, link);
  m_plan.arms.push_back(best);
}

/// A shaft reaches from the link's wheels to its bearing, its arms and cups on this axis.
void Planner::addShaft(int axisClass, int link) {
  const AxisLayout& layout = axis(axisClass);
  ShaftPlan shaft;
  shaft.axisClass = axisClass;
  shaft.link = link;
  const double half = layout.width() / 2;
  const bool turns = m_placement.classes->classOfLink(m_tree, link) == axisClass;
  for (const TrainGear& gear : m_train.gears) {
    if (gear.link != link || gear.axisClass != axisClass || gear.spec.kind == GearKind::internal) continue;
    const AxialSpan hub = hubSpan(gear.spec);
    const double sense = gear.pose.linear().col(2).dot(layout.direction) < 0 ? -1 : 1;
    const double origin = layout.coordinate(gear.pose.translation());
    for (const double z : {hub.low, hub.high}) shaft.include(origin + sense * z, origin + sense * z);
  }
  for (const ArmPlan& arm : m_plan.arms) {
    if (arm.link == link && arm.from == axisClass) shaft.include(arm.level - half, arm.level + half);
  }
  for (const CupPlan& cup : m_plan.cups) {
    const TrainGear& gear = m_train.gears[static_cast<std::size_t>(cup.gear)];
    if (gear.link == link && gear.axisClass == axisClass) shaft.include(cup.plate - half, cup.plate + half);
  }
  const Bearing* nearest = nullptr;  // what holds a wheel that does not turn here
  const auto away = [&](const Bearing& b) { return std::max({b.at - shaft.high, shaft.low - b.at, 0.0}); };
  for (const Bearing& b : layout.bearings) {
    if (b.parent == link && (nearest == nullptr || away(b) < away(*nearest))) nearest = &b;
    if (turns && (b.child == link || b.parent == link)) shaft.include(b.at - half, b.at + half);
  }
  if (!turns && nearest != nullptr) shaft.include(nearest->at - half, nearest->at + half);
  if (shaft.low < shaft.high) {
    shaft.low -= 0.5 * layout.gap();
    shaft.high += 0.5 * layout.gap();
    m_plan.shafts.push_back(shaft);
  }
}

/// Wheels that stand on an axis without turning about it are held by the bearings that their link has there,
/// rings by the tube between their cup and these.
void Planner::addFixedHubs() {
  for (const TrainGear& gear : m_train.gears) {
    const bool turns = m_placement.classes->classOfLink(m_tree, gear.link) == gear.axisClass;
    if (turns) continue;
    if (m_plan.shaftOf(gear.axisClass, gear.link) == nullptr) addShaft(gear.axisClass, gear.link);
  }
}

/// Largest radius that the bores of the link's wheels on this axis allow.
double Planner::boreRoom(int axisClass, int link) const {
  double room = 1e300;
  for (const TrainGear& gear : m_train.gears) {
    if (gear.link != link || gear.axisClass != axisClass || gear.spec.kind == GearKind::internal) continue;
    room = std::min(room, gear.spec.bore > 0 ? gear.spec.bore / 2 : 0.45 * largestBore(gear.spec));
  }
  return room;
}

/// Shafts that lie over each other are nested, the longest inmost; all of an axis shrink together until the
/// bores of their wheels hold them.
void Planner::nestShafts(int axisClass) {
  std::vector<ShaftPlan*> shafts;
  for (ShaftPlan& s : m_plan.shafts) {
    if (s.axisClass == axisClass) shafts.push_back(&s);
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
    shaft.outer = inside > 0 ? inside + 1.0 * module : 1.8 * module;
    scale = std::min(scale, boreRoom(axisClass, shaft.link) / shaft.outer);
  }
  for (ShaftPlan* shaft : shafts) {
    shaft->inner *= scale;
    shaft->outer *= scale;
  }
}

}  // namespace

const ShaftPlan* BodyPlan::shaftOf(int axisClass, int link) const {
  for (const ShaftPlan& s : shafts) {
    if (s.axisClass == axisClass && s.link == link) return &s;
  }
  return nullptr;
}

double BodyPlan::shaftAt(int axisClass, double coordinate, int link) const {
  double radius = 0;
  for (const ShaftPlan& s : shafts) {
    const bool there = s.axisClass == axisClass && s.low <= coordinate && coordinate <= s.high;
    if (there && s.link != link) radius = std::max(radius, s.outer);
  }
  return radius;
}

BodyPlan planBodies(const Mechanism& mechanism, const Placement& placement, const GearTrain& train) {
  return Planner(mechanism, placement, train).plan();
}

}  // namespace geargraph
