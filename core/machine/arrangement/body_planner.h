#pragma once

#include <map>
#include <optional>
#include <set>
#include <stop_token>
#include <utility>
#include <vector>

#include "core/machine/arrangement/arrangement.h"
#include "core/machine/arrangement/gear_obstacles.h"
#include "core/machine/train/train_wheels.h"

namespace geargraph::inline arrangement {

/// What earlier tries have shown.
struct PlanTries {
  std::set<int> onFeet;   ///< links whose bearings in the frame, across its other axes, get no arm
  std::set<int> roomFor;  ///< carriers that found no level for their arms
  /// Carriers whose arms go round bearings of the frame, and the level of these arms: the frame cannot reach
  /// what is between there and the wheels.
  std::map<int, double> roundBearings;
};

/// How arrangementOf() goes: linked sets first, then rings' cups, bearings and arms link by link, shafts at
/// last.
class BodyPlanner {
 public:
  BodyPlanner(const Mechanism& mechanism, const Placement& placement, const GearTrain& train,
              const PlanTries& tries, const std::stop_token& stop)
      : m_placement(placement),
        m_tree(*placement.tree),
        m_train(train),
        m_tries(tries),
        m_stop(stop),
        m_obstacles(train) {
    m_plan.axes = axisLayouts(mechanism, placement, train, stop);
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

  /// Carriers for whose arms there was no level.
  [[nodiscard]] const std::set<int>& wantRoom() const { return m_wantRoom; }
  /// Bodies that go straight, whatever is in their way.
  Arrangement planSimply();
  /// Ends early, with a plan of no use, when `stop` was requested.
  Arrangement plan() {
    for (std::size_t c = 0; c < m_plan.axes.size() && !isStopped(); ++c) planCoaxial(static_cast<int>(c));
    placeCups();
    const std::vector<int> links = m_tree.breadthFirst();
    for (const int link : links) {
      if (isStopped()) return std::move(m_plan);
      placeLink(link);
    }
    for (const int link : links) {
      if (isStopped()) return std::move(m_plan);
      if (link == 0) continue;
      const int c = m_placement.classes->classOfLink(link);
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
  [[nodiscard]] bool isStopped() const { return m_stop.stop_requested(); }
  void placeInRow(int axisClass);
  void planCoaxial(int axisClass);
  [[nodiscard]] bool isCoaxial(int axisClass) const { return m_coaxial[static_cast<std::size_t>(axisClass)]; }
  void placeCups();
  [[nodiscard]] int cupSideFor(const TrainGear& ring) const;
  [[nodiscard]] bool cutsPlanets(const TrainGear& ring, double plate) const;
  void placeLink(int link);
  void placeParallel(int link, int home, std::vector<Bearing*> round);
  void placeCrossing(int link, int home, Bearing& bearing);
  struct TriedArm {
    ArmPlan arm;
    int hits = 1 << 20;  ///< places that do not pass
  };
  [[nodiscard]] TriedArm bestArm(int link, int home, const Bearing& bearing,
                                 const std::vector<double>& levels) const;
  [[nodiscard]] std::vector<double> levelsBeside(int link, int home) const;
  [[nodiscard]] std::vector<double> levelsBeyond(int home, int axisClass) const;
  [[nodiscard]] int armHits(const ArmPlan& arm) const;
  [[nodiscard]] std::optional<double> commonLevel(int link, int home,
                                                  const std::vector<Bearing*>& round) const;
  [[nodiscard]] Stretch hubStretch(int axisClass, int link) const;
  [[nodiscard]] Stretch heldStretch(int axisClass, int link) const;
  [[nodiscard]] bool isCutOff(int axisClass, int link, const Stretch& held, double at) const;
  static constexpr int kReserved = -2;
  std::vector<int> reserveRoom();
  [[nodiscard]] bool isTrapped(int link, int home, double level) const;
  [[nodiscard]] bool meetsArms(const Bearing& bearing, double at) const;
  [[nodiscard]] bool sweepsShafts(int link, int home, double level, int axisClass) const;
  [[nodiscard]] std::ptrdiff_t enclosedBy(int link, int home, double level) const;
  [[nodiscard]] double outmostLevel(int home, const std::vector<Bearing*>& round) const;
  [[nodiscard]] int homeOf(int link) const;
  [[nodiscard]] std::optional<double> boltPlace(const Bearing& bearing) const;
  void boltDown(Bearing& bearing, double place);
  void boltDownOrSay(Bearing& bearing);
  [[nodiscard]] bool shaftPasses(const Bearing& bearing, double at) const;
  [[nodiscard]] bool fits(int link, int home, const std::vector<Bearing*>& round, double level) const;
  struct Bar {
    int from = 0;  ///< axis classes
    int to = 0;
  };
  [[nodiscard]] std::vector<Bar> barsOf(int link, int home, const std::vector<Bearing*>& round,
                                        double level) const;
  [[nodiscard]] int shaftHits(const ArmPlan& arm) const;
  [[nodiscard]] std::optional<std::pair<double, double>> crossingOf(int a, int b) const;
  [[nodiscard]] Stretch reachOf(const ArmPlan& arm) const;
  std::vector<Bearing>::iterator heldByTee(int link, int axisClass, double at);
  [[nodiscard]] bool isAround(int home, int link, double level) const;
  bool placeTee(int link, int home, int axisClass);
  void trimTees();
  [[nodiscard]] std::optional<PinPlan> pinFor(int link, int home, const Bearing& bearing) const;
  [[nodiscard]] std::vector<std::vector<Bearing*>> roundsOf(int link, int home);
  bool includeWheels(int axisClass, int link, ShaftSegment& shaft);
  void includeBodies(int axisClass, int link, ShaftSegment& shaft);
  void addShaft(int axisClass, int link);
  void addStub(int axisClass, ShaftSegment& shaft);
  void addArm(const ArmPlan& arm) {
    m_armsOf[static_cast<std::size_t>(arm.link)].push_back(m_plan.arms.size());
    m_plan.arms.push_back(arm);
  }
  [[nodiscard]] std::optional<double> heldLevel(int axisClass, int link) const;
  void addFixedHubs();
  [[nodiscard]] int cutsBy(const ShaftSegment& outer, int link) const;
  void nestShafts(int axisClass);
  [[nodiscard]] double boreRoom(int axisClass, int link) const;

  [[nodiscard]] int classOf(const Bearing& bearing) const {
    return m_placement.classes->classOf[static_cast<std::size_t>(bearing.joint)];
  }
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
  const PlanTries& m_tries;
  const std::stop_token& m_stop;
  std::set<int> m_wantRoom;  ///< carriers for whose arms there was no level
  GearObstacles m_obstacles;
  std::vector<std::vector<std::size_t>> m_gearsOn;  ///< gears by axis class
  std::vector<bool> m_coaxial;                      ///< axis classes that have a plan of their own
  std::vector<std::vector<std::pair<int, std::size_t>>>
      m_heldBy;                                    ///< bearings (class, place) by the link that holds
  std::vector<std::vector<std::size_t>> m_armsOf;  ///< arms by link
  Arrangement m_plan;
};

}  // namespace geargraph::inline arrangement
