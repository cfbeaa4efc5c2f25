#include "core/gears/train_bodies.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>
#include <vector>

#include "core/gears/bodies.h"
#include "core/gears/body_plan.h"
#include "core/gears/gear_body.h"

namespace geargraph {
namespace {

using Eigen::Vector3d;

class BodyBuilder {
 public:
  BodyBuilder(const BodyPlan& plan, const GearTrain& train, std::size_t links)
      : m_plan(plan), m_train(train), m_solids(links) {}

  std::vector<Solid> build() {
    for (const ShaftPlan& shaft : m_plan.shafts) addShaft(shaft);
    for (const ArmPlan& arm : m_plan.arms) addArm(arm);
    for (const ArmPlan& a : m_plan.arms) {
      const bool parallel = axis(a.from).direction.cross(axis(a.to).direction).norm() < 1e-6;
      if (parallel) m_eyes.insert({a.to, a.link, a.child});
    }
    for (const CupPlan& cup : m_plan.cups) addCup(cup);
    for (std::size_t c = 0; c < m_plan.axes.size(); ++c) {
      for (const Bearing& b : m_plan.axes[c].bearings) {
        if (!isEyeOfArm(static_cast<int>(c), b)) addBearing(static_cast<int>(c), b);
      }
    }
    return std::move(m_solids);
  }

 private:
  Solid& of(int link) { return m_solids[static_cast<std::size_t>(link)]; }
  [[nodiscard]] const AxisLayout& axis(int c) const { return m_plan.axes[static_cast<std::size_t>(c)]; }
  [[nodiscard]] Eigen::Isometry3d frame(int c, double coordinate, const Vector3d& towards) const {
    return frameAlong(axis(c).at(coordinate), axis(c).direction, towards);
  }
  [[nodiscard]] static double clearance(const AxisLayout& layout) { return 0.08 * layout.module; }
  [[nodiscard]] static double wall(const AxisLayout& layout) { return 1.0 * layout.module; }
  [[nodiscard]] static double tolerance(const AxisLayout& layout) { return kBodyTolerance * layout.module; }

  /// Hole of the parent's eye about the child's shaft.
  [[nodiscard]] double holeFor(int c, double at, int parent) const {
    const double shaft = m_plan.shaftAt(c, at, parent);
    return shaft > 0 ? shaft + clearance(axis(c)) : 0;
  }

  void addShaft(const ShaftPlan& shaft) {
    const AxisLayout& layout = axis(shaft.axisClass);
    append(of(shaft.link), tube(shaft.outer, shaft.inner, shaft.low, shaft.high, tolerance(layout)),
           frameAlong(layout.point, layout.direction));
  }

  /// An arm in the plane of the bearing has its eye there already.
  [[nodiscard]] bool isEyeOfArm(int c, const Bearing& bearing) const {
    return m_eyes.count({c, bearing.parent, bearing.child}) > 0;
  }

  void addBearing(int c, const Bearing& bearing) {
    const AxisLayout& layout = axis(c);
    const double hole = holeFor(c, bearing.at, bearing.parent);
    const double half = layout.width() / 2;
    append(of(bearing.parent),
           tube(hole + wall(layout), hole, bearing.at - half, bearing.at + half, tolerance(layout)),
           frameAlong(layout.point, layout.direction));
  }

  void addArm(const ArmPlan& plan);
  void addCup(const CupPlan& cup);

  const BodyPlan& m_plan;
  const GearTrain& m_train;
  std::vector<Solid> m_solids;
  std::set<std::tuple<int, int, int>>
      m_eyes;  ///< (axis class, parent, child) of bearings that arms bring along
};

void BodyBuilder::addArm(const ArmPlan& plan) {
  const AxisLayout& from = axis(plan.from);
  const AxisLayout& to = axis(plan.to);
  const Vector3d start = from.at(plan.level);
  const Vector3d end = to.at(plan.at);
  const double rise = (end - start).dot(from.direction);
  const Vector3d foot = end - rise * from.direction;  // in the plane of the arm
  const double length = (foot - start).norm();
  const bool parallel = from.direction.cross(to.direction).norm() < 1e-6;
  const double half = 0.5 * from.width();

  const ShaftPlan* own = m_plan.shaftOf(plan.from, plan.link);
  Eye a;
  a.hole = own != nullptr ? own->inner : holeFor(plan.from, plan.level, plan.link);
  a.radius = (own != nullptr ? own->outer : a.hole) + wall(from);
  Eye b;
  b.hole = parallel ? holeFor(plan.to, plan.at, plan.link) : 0;
  b.radius = parallel ? b.hole + wall(to) : 1.5 * from.module;
  b.centre = {length, 0};
  const Vector3d towards = length > 1e-6 * from.module ? Vector3d(foot - start) : Vector3d::UnitX();
  if (length > std::abs(a.radius - b.radius) + 1e-6 * from.module) {
    append(of(plan.link), arm(a, b, -half, half, tolerance(from)), frame(plan.from, plan.level, towards));
  }
  if (parallel) return;
  // A post from the arm to the bearing, as far as the bearing's wall.
  const double hole = holeFor(plan.to, plan.at, plan.link);
  const double reach = std::abs(rise) - hole - 0.5 * wall(to);
  if (reach <= half) return;
  const double sense = rise < 0 ? -1 : 1;
  append(of(plan.link), tube(b.radius, 0, -half * 0.9, reach, tolerance(from)),
         frameAlong(foot, sense * from.direction));
}

/// The plate beside the ring's face and the wall that joins them.
void BodyBuilder::addCup(const CupPlan& cup) {
  const TrainGear& gear = m_train.gears[static_cast<std::size_t>(cup.gear)];
  const AxisLayout& layout = axis(gear.axisClass);
  const ShaftPlan* own = m_plan.shaftOf(gear.axisClass, gear.link);
  if (own == nullptr) return;
  const double face = layout.coordinate(gear.pose.translation()) + cup.side * gear.spec.faceWidth / 2;
  const double half = 0.5 * layout.width();
  const double nearSide = cup.plate - cup.side * half;
  const double farSide = cup.plate + cup.side * half;
  const double rim = rimDiameter(gear.spec) / 2;
  const double root = nominalRootRadius(gear.spec) + 0.4 * gear.spec.module;
  const double hole = std::max(own->inner, 0.5 * own->outer);
  std::vector<Circle> meridian{{rim, farSide},   {hole, farSide}, {hole, nearSide},
                               {root, nearSide}, {root, face},    {rim, face}};
  if (cup.side < 0) std::reverse(meridian.begin(), meridian.end());
  append(of(gear.link), lathed(meridian, tolerance(layout)), frameAlong(layout.point, layout.direction));
}

}  // namespace

void addBodies(const Mechanism& mechanism, const Placement& placement, GearTrain& train) {
  const BodyPlan plan = planBodies(mechanism, placement, train);
  for (TrainGear& gear : train.gears) {
    if (gear.spec.kind == GearKind::internal) continue;
    const ShaftPlan* shaft = plan.shaftOf(gear.axisClass, gear.link);
    if (shaft != nullptr && gear.spec.bore == 0) gear.spec.bore = 2 * shaft->outer;
  }
  std::vector<Solid> solids = BodyBuilder(plan, train, mechanism.links.size()).build();
  for (std::size_t link = 0; link < solids.size(); ++link) {
    if (solids[link].empty()) continue;
    train.bodies.push_back({static_cast<int>(link), std::make_shared<const Solid>(std::move(solids[link]))});
  }
}

}  // namespace geargraph
