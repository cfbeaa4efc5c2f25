#include <QTest>
#include <algorithm>
#include <cmath>

#include "core/theory/levers/lever_motion.h"
#include "core/theory/levers/lever_plan.h"
#include "core/theory/levers/speed_plan.h"
#include "core/theory/matroid/exact_solution.h"
#include "core/theory/states/engagement.h"
#include "core/theory/states/state_solution.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/gearboxes.h"
#include "tests/core/support/matroid_fixture.h"
#include "tests/core/support/train_sketch.h"

using namespace geargraph;
using namespace geargraph::test;

namespace {

LeverPlan planOf(const Worked& worked) {
  return *leverPlanOf(worked.model, worked.placement);
}

/// "1:0 3:3/4 2:1": the points of a lever, links joined by "=", with a star where only these teeth put them.
std::string textOf(const Lever& lever) {
  std::string text;
  for (const LeverPoint& point : lever.points) {
    if (!text.empty()) text += ' ';
    for (std::size_t i = 0; i < point.links.size(); ++i)
      text += (i == 0 ? "" : "=") + std::to_string(int{point.links[i]});
    text += ':' + point.at.toString() + (point.isByMeshes ? "" : "*");
  }
  return text;
}

std::vector<std::string> textsOf(const LeverPlan& plan) {
  std::vector<std::string> texts;
  for (const Lever& lever : plan.levers) texts.push_back(textOf(lever));
  return texts;
}

std::vector<std::string> leversOf(Mechanism mechanism) {
  const Worked worked(std::move(mechanism));
  return textsOf(planOf(worked));
}

/// Ids equal the labels in this sketch, in the examples too.
std::vector<std::string> leversOfExample(const std::string& name) {
  return leversOf(example(name));
}

using Texts = std::vector<std::string>;

/// The examples that have a tree and the geometry of every mesh.
std::vector<std::string> solvableExamples() {
  std::vector<std::string> names;
  for (const std::string& name : exampleNames()) {
    const Placement placement = placementOf(example(name));
    const bool isSolvable = placement.tree && std::all_of(placement.meshes.begin(), placement.meshes.end(),
                                                          [](const auto& mesh) { return mesh.has_value(); });
    if (isSolvable) names.push_back(name);
  }
  return names;
}

/// Sets with suns 1, 4 and rings 2, 5 on one carrier 3; a third set between the suns with carrier 6, a fourth
/// between the rings with carrier 7. With equal teeth everywhere 3, 6 and 7 are on one line.
Mechanism fourSets(int lastRing) {
  TrainSketch train(11);
  for (int link = 1; link <= 7; ++link) train.joint(0, link, "a");
  train.joint(3, 8, "p").joint(3, 9, "q").joint(6, 10, "r").joint(7, 11, "s");
  train.mesh(1, 8, 20, 20, MeshKind::external).mesh(8, 2, 20, 60, MeshKind::internal);
  train.mesh(4, 9, 20, 20, MeshKind::external).mesh(9, 5, 20, 60, MeshKind::internal);
  train.mesh(1, 10, 20, 20, MeshKind::external).mesh(10, 4, 20, 60, MeshKind::internal);
  train.mesh(2, 11, lastRing - 40, 20, MeshKind::external).mesh(11, 5, 20, lastRing, MeshKind::internal);
  return train.build();
}

}  // namespace

class LeversTest : public QObject {
  Q_OBJECT

 private slots:
  void carrierDividesSunAndRingByTheirTeeth() {
    // x_C = (x_S + k x_R)/(1 + k) with k = 60/20.
    const Worked worked(planetary(20, 20));
    const LeverPlan plan = planOf(worked);
    QCOMPARE(textsOf(plan), (Texts{"1:0 3:3/4 2:1"}));
    QCOMPARE(plan.freedom, 2);
    QVERIFY(plan.levers[0].isByMeshes);
    QCOMPARE(plan.groups.at(0).teethText(), std::string("20 : 60"));
    QCOMPARE(plan.basis, (std::vector<LinkOrdinal>{1, 2}));
    QVERIFY(plan.points[3] == (std::vector<Rational>{Rational(1, 4), Rational(3, 4)}));
    QVERIFY(plan.points[0] == (std::vector<Rational>{0, 0}));  // the ground
  }

  void equalPlanetsChangeNoLever() { QCOMPARE(leversOf(planetary(20, 20, 3)), (Texts{"1:0 3:3/4 2:1"})); }

  void doublePlanetPutsTheCarrierOutside() {
    // k = -76/30: x_C = 38/23 with the sun at 0 and the ring at 1.
    TrainSketch train(5);
    for (int link = 1; link <= 3; ++link) train.joint(0, link, "a");
    train.joint(3, 4, "inner").joint(3, 5, "outer");
    train.mesh(1, 4, 30, 18, MeshKind::external).mesh(4, 5, 18, 20, MeshKind::external);
    train.mesh(5, 2, 20, 76, MeshKind::internal);
    QCOMPARE(leversOf(train.build()), (Texts{"1:0 2:23/38 3:1"}));
  }

  void ravigneauxSetIsOneLeverOfFourPoints() {
    const Worked worked(example("ravigneaux"));
    const LeverPlan plan = planOf(worked);
    QCOMPARE(plan.levers.size(), std::size_t{1});
    QCOMPARE(plan.levers[0].points.size(), std::size_t{4});
    QVERIFY(plan.levers[0].isByMeshes);
    QCOMPARE(plan.levers[0].groups.size(), std::size_t{1});
    QVERIFY(plan.levers[0].pointOf(0) == nullptr);  // the ground is off the line until something is held
  }

  void setsTiedTwiceAreOneLever() {
    const Worked worked(example("simpson"));
    const LeverPlan plan = planOf(worked);
    QCOMPARE(plan.levers.size(), std::size_t{1});
    QCOMPARE(plan.levers[0].points.size(), std::size_t{4});
    QCOMPARE(plan.levers[0].groups, (std::vector<int>{0, 1}));
  }

  void eightSpeedGearboxHasFourLevers() {
    QCOMPARE(leversOfExample("eight-speed-gearbox"),
             (Texts{"2:0 4:2/3 3:1", "2:0 1:2/3 5:1", "5:0 7:37/60 6:1", "4:0 8:23/108 6:1"}));
  }

  void aHeldRingIsThePivot() {
    const Worked worked(example("planetary-ring-held"));
    const LeverPlan plan = planOf(worked);
    QCOMPARE(plan.freedom, 1);
    QCOMPARE(plan.levers.size(), std::size_t{1});
    QVERIFY(plan.levers[0].pointOf(0) != nullptr);
  }

  void linesByToothCountsOnlyAreMarked() {
    const Worked equal(fourSets(60));
    const LeverPlan plan = planOf(equal);
    const auto accidental = std::find_if(plan.levers.begin(), plan.levers.end(), [](const Lever& lever) {
      return lever.pointOf(6) != nullptr && lever.pointOf(7) != nullptr;
    });
    QVERIFY(accidental != plan.levers.end());
    QVERIFY(accidental->pointOf(3) != nullptr);
    QVERIFY(!accidental->isByMeshes);
    QVERIFY(accidental->groups.empty());
    QCOMPARE(std::count_if(plan.levers.begin(), plan.levers.end(),
                           [](const Lever& lever) { return lever.isByMeshes; }),
             4);

    const Worked other(fourSets(80));
    QCOMPARE(planOf(other).levers.size(), std::size_t{4});
  }

  void aClutchProjectsItsLinksOntoOnePoint() {
    const Mechanism simpson = example("simpson");
    const Worked worked(simpson);
    int clutch = 0;
    while (simpson.couplings[static_cast<std::size_t>(clutch)].kind != ShiftElementKind::clutch) ++clutch;
    const auto rows = heldRows(simpson, worked.placement, clutch);
    const auto plan = leverPlanOf(worked.model, worked.placement, rows);
    QCOMPARE(plan->freedom, 1);
    // Two points of a line at one place: the whole set turns as a block.
    QCOMPARE(plan->coincident(), (std::vector<std::vector<LinkOrdinal>>{{1, 2, 3, 4}}));
  }

  void bevelGearsOnOneAxisHaveALever() {
    const Worked worked(bevelDifferential());
    const LeverPlan plan = planOf(worked);
    QCOMPARE(textsOf(plan), (Texts{"1:0 3:1/2 2:1"}));
    QCOMPARE(plan.positionOf(4), -1);  // the pinion has no place
  }

  void robotTellsWhyItHasNoLever() {
    const Worked worked(example("robot"));
    const LeverPlan plan = planOf(worked);
    QCOMPARE(plan.absence, LeverAbsence::directions);
    QCOMPARE(plan.links, (std::vector<LinkOrdinal>{0, 1, 5}));
    QCOMPARE(*plan.turningAway, MeshOrdinal(1));  // mesh 16, to axis c
  }

  void aPairOfParallelShaftsHasNoLever() {
    const Worked worked(example("spur-pair"));
    QCOMPARE(planOf(worked).absence, LeverAbsence::noMesh);
  }

  void meshesHoldBetweenPoints() {
    for (const std::string& name : solvableExamples()) {
      const Mechanism mechanism = example(name);
      const Worked worked(mechanism);
      const LeverPlan plan = planOf(worked);
      for (const MeshOrdinal mesh : worked.placement.meshes.ordinals()) {
        const MeshGeometry& geometry = *worked.placement.meshes[mesh];
        const int i = plan.positionOf(geometry.tail);
        const int j = plan.positionOf(geometry.head);
        const int k = plan.positionOf(geometry.carrier);
        if (i < 0 || j < 0 || k < 0) continue;
        const auto at = [&](int link) { return plan.points[static_cast<std::size_t>(link)]; };
        for (std::size_t d = 0; d < plan.basis.size(); ++d) {
          QVERIFY2(Rational(geometry.tailTeeth) * (at(i)[d] - at(k)[d]) ==
                       Rational(geometry.sign * geometry.headTeeth) * (at(j)[d] - at(k)[d]),
                   name.c_str());
        }
      }
    }
  }

  void speedsOfAnyMotionAreStraightOnEveryLever() {
    const auto check = [](const Mechanism& mechanism, const std::string& name) {
      const Worked worked(mechanism);
      const LeverPlan plan = planOf(worked);
      const auto& joints = worked.analysis.choice.joints;
      std::vector<Rational> inputs;
      for (std::size_t i = 0; i < joints.size(); ++i)
        inputs.emplace_back(static_cast<std::int64_t>(3 * i * i + 7));
      const auto exact = solveExact(worked.model, joints, inputs);
      const auto speeds = leverSpeeds(plan, worked.placement, exact->rates);
      for (const Lever& lever : plan.levers) {
        for (const LeverPoint& point : lever.points) {
          for (const LinkOrdinal link : point.links)
            QVERIFY2(speeds[static_cast<std::size_t>(plan.positionOf(link))] ==
                         speedAt(plan, lever, speeds, point.at),
                     name.c_str());
        }
      }
      std::vector<Rational> ofBasis;
      for (const LinkOrdinal link : plan.basis)
        ofBasis.push_back(speeds[static_cast<std::size_t>(plan.positionOf(link))]);
      QVERIFY2(speedsFromBasis(plan, ofBasis) == speeds, name.c_str());
    };
    for (const std::string& name : solvableExamples()) check(example(name), name);
    for (std::uint64_t seed = 1; seed <= 40; ++seed) check(randomTrain(seed, 14, 6), std::to_string(seed));
  }

  void leversAgreeWithTheShiftTableOfEveryExample() {
    int ratios = 0;
    for (const std::string& name : solvableExamples()) {
      const Mechanism mechanism = example(name);
      if (mechanism.states.empty()) continue;
      const Worked worked(mechanism);
      const LeverPlan plan = planOf(worked);
      const auto states = *solveStates(worked.mechanism, worked.model, worked.placement, false);
      for (const StateSolution& state : states) {
        if (!state.isSolved()) continue;
        const auto speeds = leverSpeeds(plan, worked.placement, state.rates);
        const auto speedOf = [&](LinkId id) {
          const auto link = std::find_if(plan.links.begin(), plan.links.end(),
                                         [&](LinkOrdinal each) { return mechanism.links[each].id == id; });
          return speeds[static_cast<std::size_t>(link - plan.links.begin())];
        };
        const ShiftState& document = mechanism.states[static_cast<std::size_t>(state.state)];
        const auto isOnLevers = [&](LinkId id) {
          return std::any_of(plan.links.begin(), plan.links.end(),
                             [&](LinkOrdinal each) { return mechanism.links[each].id == id; });
        };
        if (!isOnLevers(*document.drive) || !isOnLevers(*document.driven)) continue;  // beside the main axis
        QVERIFY(state.ratio.has_value());
        QVERIFY2(speedOf(*document.drive) / speedOf(*document.driven) == *state.ratio, name.c_str());
        ++ratios;
        for (const Lever& lever : plan.levers) {
          for (const LeverPoint& point : lever.points)
            QVERIFY2(
                speedOf(mechanism.links[point.links.front()].id) == speedAt(plan, lever, speeds, point.at),
                name.c_str());
        }
      }
    }
    QVERIFY(ratios >= 17);  // 9 of the eight-speed gearbox, 4 of each other
  }

  void eachStateIsAProjectionOfThePoints() {
    const Mechanism gearbox = example("eight-speed-gearbox");
    const Worked worked(gearbox);
    const auto states = *solveStates(worked.mechanism, worked.model, worked.placement, false);
    for (const StateSolution& state : states) {
      const auto engagement = engagementOf(gearbox, worked.placement, state.engaged);
      const auto plan = leverPlanOf(worked.model, worked.placement, engagement.rows);
      QCOMPARE(plan->freedom, 1);
      // w_in / w_out = (x_in - x_ground) / (x_out - x_ground) on the line that is left.
      QVERIFY(plan->points[1][0] / plan->points[8][0] == *state.ratio);
    }
  }

  void linesOfTheSpeedPlanMeetAtTeethAndCarriedAxes() {
    int meshes = 0;
    int carried = 0;
    int parallels = 0;
    for (const std::string& name : solvableExamples()) {
      const Worked worked(example(name));
      if (!worked.analysis.solution) continue;
      const auto exact = solveExact(worked.model, worked.analysis.choice.joints, worked.analysis.speeds);
      const SpeedPlan plan = speedPlanOf(worked.placement, exact->rates);
      if (plan.absence != SpeedPlanAbsence::none) continue;
      double size = 0;
      for (const SpeedPlan::Line& line : plan.lines)
        size = std::max({size, std::abs(line.velocityAt(line.low)), std::abs(line.velocityAt(line.high))});
      const auto at = [&](LinkOrdinal link, double height) {
        return plan.lines[static_cast<std::size_t>(int{link})].velocityAt(height);
      };
      QCOMPARE(plan.crossings.size() + plan.apart.size() + plan.alike.size(),
               static_cast<std::size_t>(worked.model.c()));
      for (const MeshOrdinal mesh : plan.alike) {
        const MeshGeometry& pair = *worked.placement.meshes[mesh];
        QCOMPARE(plan.lines[static_cast<std::size_t>(int{pair.tail})].speed,
                 plan.lines[static_cast<std::size_t>(int{pair.head})].speed);
        ++parallels;
      }
      for (const SpeedPlan::Crossing& crossing : plan.crossings) {
        const MeshGeometry& mesh = *worked.placement.meshes[crossing.mesh];
        const double apart = at(mesh.tail, crossing.height) - at(mesh.head, crossing.height);
        QVERIFY2(std::abs(apart) <= 1e-9 * size, name.c_str());
        ++meshes;
      }
      for (const AxisGroupOrdinal axis : plan.axes.ordinals()) {
        const LinkOrdinal carrier = worked.placement.classes->classes[axis].rootLink;
        const double apart = at(carrier, plan.axes[axis].height) - plan.axes[axis].velocity;
        QVERIFY2(std::abs(apart) <= 1e-9 * size, name.c_str());
        carried += carrier != 0 ? 1 : 0;
      }
    }
    QVERIFY(meshes > 20 && carried > 10 && parallels > 1);
  }

  void speedPlanOfASetWithItsRingHeld() {
    const Worked worked(example("planetary-ring-held"));
    const auto exact = solveExact(worked.model, worked.analysis.choice.joints, worked.analysis.speeds);
    const SpeedPlan plan = speedPlanOf(worked.placement, exact->rates);
    QCOMPARE(plan.crossings.size(), std::size_t{2});
    QVERIFY(std::abs(plan.crossings[0].height / plan.crossings[1].height - 24.0 / 60) < 1e-12);
    QVERIFY(std::abs(plan.crossings[1].velocity) < 1e-12);  // the ring is held
    QVERIFY(plan.lines[0].speed.isZero());
    QVERIFY(plan.lines[1].speed == Rational(1));
    QVERIFY(plan.lines[2].speed == Rational(2, 7));
    QVERIFY(plan.lines[3].speed == Rational(2, 7) * (Rational(1) - Rational(60, 18)));
  }

  void planetsThatMeshBesideTheRadiusAreToldApart() {
    const Worked worked(example("ravigneaux"));
    const auto exact = solveExact(worked.model, worked.analysis.choice.joints, worked.analysis.speeds);
    const SpeedPlan plan = speedPlanOf(worked.placement, exact->rates);
    QCOMPARE(plan.apart, (std::vector<MeshOrdinal>{1}));
    QCOMPARE(plan.crossings.size(), std::size_t{3});
  }

  void speedPlansThatAreAbsent() {
    const Worked robot(example("robot"));
    QVERIFY(speedPlanOf(robot.placement, std::vector<Rational>(static_cast<std::size_t>(robot.model.t())))
                .absence == SpeedPlanAbsence::directions);
    const Worked pair(example("spur-pair"));
    QVERIFY(speedPlanOf(pair.placement, {}).absence == SpeedPlanAbsence::noMotion);
    QVERIFY(speedPlanOf(placementOf(example("robot-to-mend")), {}).absence == SpeedPlanAbsence::unfinished);
  }

  void stoppingEndsThePlan() {
    std::stop_source stop;
    stop.request_stop();
    const Worked worked(example("eight-speed-gearbox"));
    QVERIFY(!leverPlanOf(worked.model, worked.placement, {}, stop.get_token()));
  }
};

QTEST_APPLESS_MAIN(LeversTest)
#include "test_levers.moc"
