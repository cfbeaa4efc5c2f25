#pragma once

#include <Eigen/Core>
#include <map>
#include <optional>
#include <set>
#include <stop_token>
#include <utility>
#include <vector>

#include "core/machine/body_layout/arrangement.h"
#include "core/machine/body_layout/gear_obstacles.h"
#include "core/machine/solids/gear_body.h"

namespace geargraph {

constexpr double kEqual = 1e-6;  ///< modules: lengths that differ by less are equal in sorting

/// The results of earlier tries.
struct PlanTries {
  std::set<int> onPedestals;  ///< links whose bearings in the frame, on axes across its others, get no arm
  std::set<int> slotsFor;     ///< carriers that found no level for their arms
  /// Carriers whose arms revolve around bearings of the frame, with the level of these arms: the frame cannot
  /// reach bearings between that level and the wheels.
  std::map<int, double> roundBearings;
};

/// An arrangement under construction. The parts of the planner (ring_carriers.h, parallel_arms.h,
/// cross_shaft_bosses.h, intersecting_arms.h, shaft_extents.h, nested_shafts.h) read it and add to it; each
/// can be tested by itself. The arguments of the constructor outlive it.
struct PlanDraft {
  /// The axes with their wheels, nothing placed. Cost: that of axisLayouts().
  PlanDraft(const Mechanism& mechanism, const Placement& placement, const GearTrain& train,
            const PlanTries& tries, const std::stop_token& stop);

  [[nodiscard]] bool isStopped() const { return stop.stop_requested(); }
  AxisLayout& axis(AxisGroupOrdinal c) { return plan.axes[c]; }
  [[nodiscard]] const AxisLayout& axis(AxisGroupOrdinal c) const { return plan.axes[c]; }
  [[nodiscard]] bool isCoaxial(AxisGroupOrdinal axisGroup) const { return coaxial[axisGroup]; }
  [[nodiscard]] int classOf(const Bearing& bearing) const {
    return placement.classes->classOf[bearing.joint];
  }
  [[nodiscard]] bool parallel(AxisGroupOrdinal a, AxisGroupOrdinal b) const {
    return axis(a).direction.cross(axis(b).direction).norm() < 1e-6;
  }
  /// Coordinate along class b of the plane through coordinate x of a parallel class a.
  [[nodiscard]] double carried(AxisGroupOrdinal a, double x, AxisGroupOrdinal b) const {
    return axis(b).coordinate(axis(a).at(x));
  }
  /// Where two axes intersect: the coordinates of the point along them; std::nullopt if they are skew or
  /// parallel.
  [[nodiscard]] std::optional<std::pair<double, double>> intersectionOf(AxisGroupOrdinal a,
                                                                        AxisGroupOrdinal b) const;
  /// A span along a gear's own axis as an interval of its axis class.
  [[nodiscard]] Interval intervalOf(const TrainGear& gear, const AxialSpan& span) const;

  void addArm(const ArmPlan& arm) {
    armsOf[arm.link].push_back(plan.arms.size());
    plan.arms.push_back(arm);
  }
  void addSegment(const ShaftSegment& shaft) {
    plan.shaftsOn[shaft.axisGroup].push_back(plan.shafts.size());
    plan.shafts.push_back(shaft);
  }

  const Placement& placement;
  const GearTrain& train;
  const PlanTries& tries;
  const std::stop_token& stop;
  std::set<int> wantSlots;  ///< carriers whose arms found no level
  GearObstacles obstacles;
  ByClass<std::vector<GearOrdinal>> gearsOn;  ///< gears
  ByClass<bool> coaxial;                      ///< axis classes with a coaxial plan
  std::vector<std::vector<std::pair<int, std::size_t>>>
      heldBy;                               ///< bearings (class, place) by the link that holds
  ByLink<std::vector<std::size_t>> armsOf;  ///< arms
  Arrangement plan;
};

}  // namespace geargraph
