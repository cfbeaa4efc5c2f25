#include <QTest>
#include <map>

#include "core/mechanism/model/edits.h"
#include "core/theory/matroid/exact_solution.h"
#include "core/theory/states/relative_speed.h"
#include "core/theory/states/state_solution.h"
#include "tests/core/support/gearboxes.h"
#include "tests/core/support/matroid_fixture.h"
#include "tests/core/support/train_sketch.h"
#include "tests/core/support/trains.h"

using namespace geargraph;
using namespace geargraph::test;

namespace {

std::vector<StateSolution> solved(const Mechanism& mechanism) {
  const Worked worked(mechanism);
  return *solveStates(worked.mechanism, worked.model, worked.placement);
}

StateSolution only(Mechanism mechanism, const std::vector<const char*>& engaged, int drive, int driven) {
  mechanism.states.clear();
  addState(mechanism, "s", engaged, drive, driven);
  return solved(mechanism).at(0);
}

/// Simpson: suns 33 (1), first ring 74 (2), output (3), second carrier (4).
Mechanism simpson() {
  Mechanism mechanism = TrainSketch(6)
                            .joint(0, 1, "a")
                            .joint(0, 2, "a")
                            .joint(0, 3, "a")
                            .joint(0, 4, "a")
                            .joint(3, 5, "front")
                            .joint(4, 6, "rear")
                            .mesh(1, 5, 33, 20, MeshKind::external)
                            .mesh(5, 2, 20, 73, MeshKind::internal)
                            .mesh(1, 6, 33, 20, MeshKind::external)
                            .mesh(6, 3, 20, 73, MeshKind::internal)
                            .build();
  addBrake(mechanism, "B1", 1);
  addBrake(mechanism, "B2", 4);
  addClutch(mechanism, "C", 1, 2);
  addState(mechanism, "1", {"B2"}, 2, 3);
  addState(mechanism, "2", {"B1"}, 2, 3);
  addState(mechanism, "3", {"C"}, 2, 3);
  addState(mechanism, "R", {"B2"}, 1, 3);
  return mechanism;
}

/// Small sun 30 (1), large sun 36 (2), ring 76 (3), carrier (4), long planet 5, short planet 6, and an input
/// shaft 7 that clutches tie to the suns.
Mechanism ravigneaux() {
  TrainSketch train(7);
  for (int link = 1; link <= 4; ++link) train.joint(0, link, "a");
  train.joint(4, 5, "long").joint(4, 6, "short").joint(0, 7, "a");
  train.mesh(1, 6, 30, 18, MeshKind::external).mesh(6, 5, 18, 20, MeshKind::external);
  train.mesh(2, 5, 36, 20, MeshKind::external).mesh(5, 3, 20, 76, MeshKind::internal);
  Mechanism mechanism = train.build();
  addClutch(mechanism, "K1", 7, 1);
  addClutch(mechanism, "K2", 7, 2);
  addClutch(mechanism, "K3", 7, 4);
  addBrake(mechanism, "B1", 4);
  addBrake(mechanism, "B2", 2);
  addState(mechanism, "1", {"K1", "B1"}, 7, 3);
  addState(mechanism, "2", {"K1", "B2"}, 7, 3);
  addState(mechanism, "3", {"K1", "K3"}, 7, 3);
  addState(mechanism, "4", {"K3", "B2"}, 7, 3);
  addState(mechanism, "R", {"K2", "B1"}, 7, 3);
  return mechanism;
}

}  // namespace

class StatesTest : public QObject {
  Q_OBJECT

 private slots:
  void theEightSpeedGearboxHasItsPublishedRatios() {
    const std::map<std::string, double> published{{"1", 4.6957}, {"2", 3.1304}, {"3", 2.1039},
                                                  {"4", 1.6667}, {"5", 1.2845}, {"6", 1.0000},
                                                  {"7", 0.8392}, {"8", 0.6667}, {"R", -3.2968}};
    const Mechanism gearbox = eightSpeed();
    const auto states = solved(gearbox);
    QCOMPARE(states.size(), published.size());
    for (const StateSolution& state : states) {
      const std::string& name = gearbox.states[static_cast<std::size_t>(state.state)].name;
      QCOMPARE(state.dof, 1);
      QVERIFY(state.diagnostics.empty());
      QVERIFY2(std::abs(state.ratio->toDouble() - published.at(name)) < 5e-5, name.c_str());
      QCOMPARE(state.rates[0], Rational(1));
    }
    QCOMPARE(*states[0].ratio, Rational(108, 23));
    QCOMPARE(*states[3].ratio, Rational(5, 3));
  }

  void theSymbolicRatioGivesTheExactOneAtTheTeeth() {
    const Mechanism gearbox = eightSpeed();
    std::vector<Rational> ratios;
    for (const GearMesh& mesh : gearbox.gearMeshes) ratios.emplace_back(mesh.tailTeeth, mesh.headTeeth);
    for (const StateSolution& state : solved(gearbox)) {
      QVERIFY(state.symbolicRatio);
      QCOMPARE(*state.symbolicRatio->valueAt(ratios), *state.ratio);
    }
  }

  void stepsAreRatiosOfNeighbours() {
    const auto states = solved(eightSpeed());
    QCOMPARE(*stepBetween(states[0], states[1]), Rational(3, 2));  // 4.6957 / 3.1304
    QVERIFY(!stepBetween(states[7], states[8]));                   // into reverse
  }

  void simpsonsThreeSpeeds() {
    const auto states = solved(simpson());
    QCOMPARE(*states[0].ratio, Rational(2) + Rational(33, 73));
    QCOMPARE(*states[1].ratio, Rational(1) + Rational(33, 73));
    QCOMPARE(*states[2].ratio, Rational(1));
    QCOMPARE(*states[3].ratio, Rational(-73, 33));
  }

  void ravigneauxsFourSpeeds() {
    const auto states = solved(ravigneaux());
    QCOMPARE(*states[0].ratio, Rational(76, 30));
    QCOMPARE(*states[1].ratio, Rational(66, 30) / Rational(112, 76));
    QCOMPARE(*states[2].ratio, Rational(1));
    QCOMPARE(*states[3].ratio, Rational(76, 112));
    QCOMPARE(*states[4].ratio, Rational(-76, 36));
  }

  void aStateThatLocksNamesEachCouplingThatWouldFreeIt() {
    Mechanism gearbox = eightSpeed();
    gearbox.states = {{"N",
                       {ShiftElementId("A"), ShiftElementId("B"), ShiftElementId("C"), ShiftElementId("E")},
                       LinkId("1"),
                       LinkId("2"),
                       {}}};
    const StateSolution state = solved(gearbox).at(0);
    QCOMPARE(state.dof, 0);
    QVERIFY(!state.ratio && !state.driveTurns && !state.isSolved());
    QCOMPARE(state.diagnostics.size(), std::size_t(1));
    QCOMPARE(state.diagnostics[0].code, Code::stateLocked);
    QCOMPARE(state.diagnostics[0].severity(), Severity::warning);
    const auto& blamed = state.diagnostics[0].elements;
    const auto names = [&](const char* id) {
      return std::find(blamed.begin(), blamed.end(), ElementId(ShiftElementId(id))) != blamed.end();
    };
    QVERIFY(names("A") && names("C") && names("E"));
    QVERIFY(!names("B"));  // A, C and E hold the drive without it: 5 = 7 = 8 = 1, but 8 turns at 3/2
  }

  void aBrakeOnTheDriveIsTheOneToRelease() {
    Mechanism mechanism = simpson();
    addBrake(mechanism, "X", 2);
    const StateSolution state = only(mechanism, {"X"}, 2, 3);
    QCOMPARE(state.diagnostics.at(0).code, Code::stateLocked);
    const std::vector<ElementId>& blamed = state.diagnostics[0].elements;
    QCOMPARE(std::count_if(blamed.begin(), blamed.end(),
                           [](const ElementId& element) { return element.kind == ElementKind::coupling; }),
             1L);
    QVERIFY(std::find(blamed.begin(), blamed.end(), ElementId(ShiftElementId("X"))) != blamed.end());
  }

  void aStateThatLeavesFreedomNamesTheLinksThatStillTurn() {
    const StateSolution state = only(simpson(), {}, 2, 3);
    QCOMPARE(state.dof, 2);
    QVERIFY(!state.ratio);
    QCOMPARE(state.diagnostics.at(0).code, Code::stateFree);
    const auto& blamed = state.diagnostics[0].elements;
    const auto names = [&](int link) {
      return std::find(blamed.begin(), blamed.end(), ElementId(LinkId(std::to_string(link)))) != blamed.end();
    };
    QVERIFY(names(1) && names(3) && names(4) && !names(2));
  }

  /// A second planetary set that nothing holds idles beside the first.
  void linksThatIdleLeaveTheRatio() {
    Mechanism mechanism = TrainSketch(5)
                              .joint(0, 1, "a")
                              .joint(0, 2, "a")
                              .joint(2, 3, "b")
                              .joint(0, 4, "a")
                              .joint(2, 5, "c")
                              .mesh(1, 3, 24, 18, MeshKind::external)
                              .mesh(3, 0, 18, 60, MeshKind::internal)
                              .mesh(4, 5, 20, 22, MeshKind::external)
                              .build();
    const StateSolution state = only(mechanism, {}, 1, 2);
    QCOMPARE(state.dof, 2);
    QCOMPARE(*state.ratio, Rational(7, 2));
    QVERIFY(state.symbolicRatio);
    const Mechanism& train = mechanism;
    std::vector<Rational> ratios;
    for (const GearMesh& mesh : train.gearMeshes) ratios.emplace_back(mesh.tailTeeth, mesh.headTeeth);
    QCOMPARE(*state.symbolicRatio->valueAt(ratios), Rational(7, 2));
    QCOMPARE(state.diagnostics.at(0).code, Code::stateIdle);
    QCOMPARE(state.diagnostics[0].severity(), Severity::info);
    QVERIFY(state.diagnostics[0].message.find("links 4 and 5 turn freely") != std::string::npos);
    QVERIFY(!state.isIdle(0) && !state.isIdle(1) && !state.isIdle(2) && state.isIdle(3) && state.isIdle(4));
    // The other way round the drive does not determine what it drives.
    QCOMPARE(only(mechanism, {}, 1, 4).diagnostics.at(0).code, Code::stateFree);
    QVERIFY(!only(mechanism, {}, 1, 4).ratio);
  }

  void aStateMayLockItsDriveAndLeaveOthersFree() {
    Mechanism mechanism = TrainSketch(3).joint(0, 1, "a").joint(0, 2, "b").joint(0, 3, "c").build();
    addBrake(mechanism, "B", 1);
    const StateSolution state = only(mechanism, {"B"}, 1, 2);
    QCOMPARE(state.dof, 2);
    QCOMPARE(state.diagnostics.size(), std::size_t(2));
    QCOMPARE(state.diagnostics[0].code, Code::stateLocked);
    QCOMPARE(state.diagnostics[1].code, Code::stateFree);
  }

  void aClutchLocksABevelDifferential() {
    for (const char* clutch : {"L", "S"}) {
      const StateSolution state = only(bevelDifferential(), {clutch}, 3, 2);
      QCOMPARE(state.dof, 1);
      QCOMPARE(*state.ratio, Rational(1));
      QCOMPARE(state.rates[3], Rational(0));  // the pinion rides along
    }
  }

  void aHeldCarrierTurnsTheSideWheelsAgainstEachOther() {
    const StateSolution state = only(bevelDifferential(), {"C"}, 1, 2);
    QCOMPARE(*state.ratio, Rational(-1));
  }

  void aBrakeOnTheBevelPinionHoldsItsCarrierToo() {
    // w_pinion = q_carrier x + q_pinion y: both have to vanish, so nothing is left.
    const StateSolution state = only(bevelDifferential(), {"P"}, 1, 2);
    QCOMPARE(state.dof, 0);
    QCOMPARE(state.diagnostics.at(0).code, Code::stateLocked);
  }

  void aPairAtRightAnglesHasARatioAboutItsOwnAxes() {
    Mechanism mechanism = TrainSketch(2)
                              .axis("a", {"0", "0", "0"}, {"1", "0", "0"})
                              .axis("b", {"0", "0", "0"}, {"0", "1", "0"})
                              .joint(0, 1, "a")
                              .joint(0, 2, "b")
                              .mesh(1, 2, 20, 30, MeshKind::bevel, {"30", "20", "0"})
                              .build();
    QCOMPARE(only(mechanism, {}, 1, 2).ratio->abs(), Rational(3, 2));
  }

  void aDrivenLinkThatStandsHasNoRatio() {
    const StateSolution state = only(bevelDifferential(), {"C"}, 1, 3);
    QVERIFY(state.isSolved() && state.isDrivenAtRest && !state.ratio);
    QVERIFY(state.diagnostics.empty());
  }

  void aCouplingOverFourDirectionsIsALinkage() {
    Mechanism arm = TrainSketch(4)
                        .axis("a", {"0", "0", "0"}, {"0", "0", "1"})
                        .axis("b", {"0", "0", "0"}, {"1", "0", "0"})
                        .axis("c", {"0", "0", "0"}, {"0", "1", "1"})
                        .axis("d", {"0", "0", "0"}, {"1", "1", "0"})
                        .joint(0, 1, "a")
                        .joint(1, 2, "b")
                        .joint(2, 3, "c")
                        .joint(3, 4, "d")
                        .build();
    addBrake(arm, "B", 4);
    addBrake(arm, "near", 3);
    const StateSolution state = only(arm, {"B"}, 1, 2);
    QCOMPARE(state.diagnostics.at(0).code, Code::turningLoop);
    QVERIFY(!state.isSolved());
    QCOMPARE(only(arm, {"near"}, 4, 4).dof, 1);  // three held directions leave the last joint
  }

  void aWristWhoseOuterAxesCoincideHoldsTheirSum() {
    // Axes 1 and 3 are one line in the reference pose, and different axes: a brake on the tool leaves the
    // motion that turns both against each other.
    Mechanism wrist = TrainSketch(3)
                          .axis("a", {"0", "0", "0"}, {"0", "0", "1"})
                          .axis("b", {"0", "0", "0"}, {"0", "1", "0"})
                          .axis("c", {"0", "0", "0"}, {"0", "0", "-2"})
                          .joint(0, 1, "a")
                          .joint(1, 2, "b")
                          .joint(2, 3, "c")
                          .build();
    addBrake(wrist, "B", 3);
    const StateSolution state = only(wrist, {"B"}, 1, 2);
    QCOMPARE(state.dof, 1);
    QCOMPARE(state.rates[1], Rational(0));
    QCOMPARE(state.rates[2], Rational(1));  // axis c points the other way
    QCOMPARE(*state.ratio, Rational(1));
  }

  void theSpeedsObeyEveryMeshAndEveryCouplingInVectors() {
    const Worked worked(eightSpeed());
    const auto states = solveStates(worked.mechanism, worked.model, worked.placement);
    for (const StateSolution& state : *states) {
      std::vector<double> rates;
      for (const Rational& rate : state.rates) rates.push_back(rate.toDouble());
      const auto velocity = linkVelocities(worked.model, worked.placement, rates);
      const auto at = [&](LinkId link) { return velocity[static_cast<std::size_t>(std::stoi(link.text()))]; };
      for (const ShiftElementId id : worked.mechanism.states[static_cast<std::size_t>(state.state)].engaged) {
        const ShiftElement& coupling = *worked.mechanism.find(id);
        const Vector3 other =
            coupling.kind == ShiftElementKind::brake ? Vector3{} : at(coupling.links.back());
        QVERIFY(length(at(coupling.links.front()) - other) < 1e-12);
      }
      for (std::size_t m = 0; m < worked.placement.meshes.size(); ++m) {
        // The velocities of both gears at the pitch point agree, seen from the carrier.
        const MeshGeometry& mesh = *worked.placement.meshes[m];
        const auto slip = [&](int gear, int axisGroup) {
          return cross(
              velocity[static_cast<std::size_t>(gear)] - velocity[static_cast<std::size_t>(mesh.carrier)],
              mesh.pitchPoint - worked.placement.lineOfClass(axisGroup).point);
        };
        QVERIFY(length(slip(mesh.tail, mesh.tailClass) - slip(mesh.head, mesh.headClass)) < 1e-9);
      }
    }
  }

  void absoluteSpeedsAddUpToTheVelocityVectors() {
    Mechanism mechanism = robot();
    mechanism.inputs = std::vector<Input>{
        {JointId("8"), Number(1), {}}, {JointId("9"), Number(-2), {}}, {JointId("11"), Number(3), {}}};
    const Worked worked(mechanism);
    const auto exact = solveExact(worked.model, worked.analysis.choice.joints, worked.analysis.speeds);
    for (int link = 0; link <= worked.mechanism.n(); ++link) {
      Vector3 sum{};
      for (const SpeedAbout& about : absoluteSpeed(worked.placement, exact->rates, link)) {
        QVERIFY(!about.speed.isZero());
        sum = sum + about.speed.toDouble() * worked.placement.lineOfClass(about.axisGroup).direction;
      }
      QVERIFY(length(sum - worked.analysis.linkVelocities[static_cast<std::size_t>(link)]) < 1e-12);
    }
  }

  void deletingALinkTakesItsCouplingsOutOfTheStates() {
    const std::vector<ElementId> gone{LinkId("3")};
    const Mechanism less = *withoutElements(eightSpeed(), gone);
    QVERIFY(less.find(ShiftElementId("A")) == nullptr);
    QCOMPARE(less.states[0].engaged, (std::vector{ShiftElementId("B"), ShiftElementId("C")}));
  }
};

QTEST_APPLESS_MAIN(StatesTest)
#include "test_states.moc"
