#include <QTest>

#include "core/mechanism/model/load_edits.h"
#include "core/theory/statics/shift_statics.h"
#include "tests/core/support/diagnostic_codes.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/gearboxes.h"
#include "tests/core/support/statics_case.h"
#include "tests/core/support/train_sketch.h"

using namespace geargraph;
using namespace geargraph::test;

namespace {

Load onLink(const char* link, const Rational& torque) {
  return {{}, LinkTorque{LinkId(link), {}, Number(torque)}};
}

StaticsOptions lossy(const Rational& efficiency, std::vector<Load> loads = {}) {
  StaticsOptions options;
  options.losses = true;
  options.efficiency = efficiency;
  options.loads = std::move(loads);
  return options;
}

std::string wordsOf(const StaticsReport& report, Code code) {
  for (const Diagnostic& diagnostic : report.diagnostics)
    if (diagnostic.code == code) return diagnostic.message;
  return {};
}

bool contains(const std::string& text, const char* part) {
  return text.find(part) != std::string::npos;
}

std::vector<StateForces> shiftOf(const StaticsCase& train, const StaticsOptions& options) {
  std::vector<StateForces> states;
  for (int state = 0; state < static_cast<int>(train.mechanism.states.size()); ++state)
    states.push_back(*solveShiftState(train.mechanism, train.model, train.placement, train.tt, train.analysis,
                                      state, options));
  return states;
}

Rational efficiencyOf(const StateForces& state) {
  return *state.ofEfficiency().sums->efficiency()->fraction();
}

/// A planetary set with its ring in the ground, which link 1 drives and link 2 leaves; its carrier bears a
/// second planet with a second sun, link 4, that nothing holds unless brake B does.
Mechanism withIdler() {
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
  addBrake(mechanism, "B", 4);
  addState(mechanism, "1", {}, 1, 2);
  addState(mechanism, "2", {"B"}, 1, 2);
  return mechanism;
}

}  // namespace

/// What a report answers, and what it leaves out with a reason: never the torques of another train.
class AnsweredStaticsTest : public QObject {
  Q_OBJECT

 private slots:
  /// Issue 45: 20/7 N m without losses; with them the planets' shares matter.
  void lossesOfThreePlanets() {
    const StaticsCase train(example("three-planets"));
    const StaticsReport report = reportOf(train, lossy({95, 100}, {onLink("2", -10)}));
    QVERIFY(report.isAnswered() && report.isShared);
    QCOMPARE(*train.balance(report.lossless, 0).fraction(), Rational(20, 7));
    QCOMPARE(*train.balance(report.solution(), 0).fraction(), Rational(1600, 521));
    QVERIFY(report.sums->lost.sign() > 0);
    QVERIFY(report.isAssumed(train.model.c()));  // the balance depends on the shares, too
    QVERIFY(report.ranges[0] && report.ranges[0]->least == Real(Rational(1600, 521)) &&
            report.ranges[0]->most == Real(Rational(1600, 521)));
    const std::string message = wordsOf(report, Code::staticallyIndeterminate);
    QVERIFY2(contains(message, "given for equally stiff teeth, an assumption"), message.c_str());
    QVERIFY2(contains(message, "joint 6: 3.07 N m"), message.c_str());

    // By stiffness that was asked for it is the same; left open there is none.
    StaticsOptions options = lossy({95, 100}, {onLink("2", -10)});
    options.sharing = LoadSharing::stiffness;
    QCOMPARE(*train.balance(reportOf(train, options).solution(), 0).fraction(), Rational(1600, 521));
    options.sharing = LoadSharing::none;
    const StaticsReport open = reportOf(train, options);
    QVERIFY(open.lossless.isBalanced() && !open.isAnswered() && !open.sums && !open.flow);
    QVERIFY(open.forces.bearings.empty());
    QVERIFY(contains(wordsOf(open, Code::staticallyIndeterminate), "share by stiffness"));
    options.losses = false;
    QVERIFY(reportOf(train, options).isAnswered());
  }

  /// The worst share is that of the worst planet alone, the best that of the best.
  void theRangeOfAllShares() {
    Mechanism planets = example("three-planets");
    planets.gearMeshes[0].efficiency = Number(Rational(8, 10));
    const StaticsCase train(planets);
    const StaticsReport report = reportOf(train, lossy({95, 100}, {onLink("2", -10)}));
    const auto alone = [](const Rational& both) {
      return Rational(10) / (Rational(1) + Rational(5, 2) * both);
    };
    QVERIFY(report.ranges[0].has_value());
    QCOMPARE(*report.ranges[0]->least.fraction(), alone(Rational(95 * 95, 10000)));
    QCOMPARE(*report.ranges[0]->most.fraction(), alone(Rational(80 * 95, 10000)));
    const Rational shared = *train.balance(report.solution(), 0).fraction();
    QVERIFY(report.ranges[0]->least.number() < shared.toDouble());
    QVERIFY(shared.toDouble() < report.ranges[0]->most.number());
  }

  /// Without losses the members of self-stresses, with them also what the train passes on.
  void whatDependsOnTheShares() {
    const Mechanism planets = planetary(24, 18, 3);
    StaticsOptions options = lossy({95, 100}, {{{}, JointTorque{planets.turningJoints[2].id, Number(-10)}}});
    options.balances = {{planets.turningJoints[0].id}, {planets.turningJoints[1].id}};
    Mechanism driven = planets;
    driven.inputs = std::vector<Input>{{planets.turningJoints[0].id, Number(1), {}},
                                       {planets.turningJoints[1].id, Number(0), {}}};
    const StaticsCase moving(driven);
    const StaticsReport report = reportOf(moving, options);
    QVERIFY(report.isAnswered());
    for (int unknown = 0; unknown < report.lossless.unknowns; ++unknown) QVERIFY(report.isAssumed(unknown));
    options.losses = false;
    options.sharing = LoadSharing::stiffness;
    const StaticsReport lossless = reportOf(moving, options);
    QVERIFY(lossless.isAssumed(0) && !lossless.isAssumed(moving.model.c()));
    QVERIFY(lossless.ranges.empty());
  }

  /// Ferguson's wheel of 99 teeth can be driven by the carrier, but not the other way, whatever its sense.
  void aTrainThatLocksHasNoTorques() {
    const StaticsCase train(example("ferguson-paradox"));
    int locked = 0;
    for (const int torque : {1, -1}) {
      const StaticsReport report = reportOf(train, lossy({99, 100}, {onLink("3", torque)}));
      QVERIFY(report.lossless.isBalanced());
      const auto codes = codesOf(report.diagnostics);
      const bool isLocked = std::find(codes.begin(), codes.end(), Code::selfLocking) != codes.end();
      QCOMPARE(report.isAnswered(), !isLocked);
      if (!isLocked) continue;
      ++locked;
      QVERIFY(!report.sums && !report.flow && !report.latentRatio && !report.loads[0].watts);
      QVERIFY(report.forces.bearings.empty() && report.forces.meshes.empty());
    }
    QCOMPARE(locked, 1);
  }

  void withoutSpeedsLossesAreNotLeftOut() {
    Mechanism gearbox = eightSpeed();
    gearbox.states[0].engaged.pop_back();  // two freedoms
    const StaticsCase train(gearbox);
    StaticsOptions options = lossy({98, 100});
    options.state = 0;
    options.balances = {{HoldingTorque::OnLink{LinkId("2"), {}}}, {HoldingTorque::OnLink{LinkId("7"), {}}}};
    const StaticsReport report = reportOf(train, options);
    QVERIFY(report.lossless.isBalanced() && !report.motion && !report.isAnswered());
    QVERIFY(contains(wordsOf(report, Code::noMotion), "torques and powers are left out"));
    options.losses = false;
    QVERIFY(reportOf(train, options).isAnswered());
  }

  void atRestNothingIsLost() {
    Mechanism pair = example("spur-pair");
    for (Input& input : *pair.inputs) input.speed = Number(0);
    const StaticsCase train(pair);
    const StaticsReport report = reportOf(train, lossy({9, 10}, {onLink("2", -10)}));
    QVERIFY(report.isAnswered());
    QVERIFY(contains(wordsOf(report, Code::noMotion), "at rest no power is lost"));
  }

  /// Issue 45: "efficiency 1" in a lossy train.
  void aLoadThatABalanceCancels() {
    const StaticsCase train(example("spur-pair"));
    const StaticsReport report = reportOf(train, lossy({9, 10}, {onLink("1", 10)}));
    QCOMPARE(codesOf(report.diagnostics), std::vector{Code::loadOnBalance});
    const std::string message = wordsOf(report, Code::loadOnBalance);
    QVERIFY2(contains(message, "The load on link 1 acts where the balance at joint 3 holds"),
             message.c_str());
    QVERIFY(report.sums->fed.isZero() && !report.sums->efficiency());
    QCOMPARE(*train.balance(report.solution(), 0).fraction(), Rational(-10));
    // Beside a load that the train passes, its efficiency is that of this load.
    const auto both = reportOf(train, lossy({9, 10}, {onLink("1", 10), onLink("2", -10)}));
    QCOMPARE(*both.sums->efficiency()->fraction(), Rational(9, 10));
    const auto alone = reportOf(train, lossy({9, 10}, {onLink("2", -10)}));
    QCOMPARE(*alone.sums->efficiency()->fraction(), Rational(9, 10));
    QVERIFY(codesOf(alone.diagnostics).empty());
    // A force with an arm about that axis is cancelled as well, one through it has no power.
    const Load pull{
        {}, LinkForce{LinkId("1"), {Number(0), Number(5), Number(0)}, {Number(8), Number(0), Number(0)}}};
    const auto codes = codesOf(reportOf(train, lossy({9, 10}, {pull})).diagnostics);
    QVERIFY(std::find(codes.begin(), codes.end(), Code::loadOnBalance) != codes.end());
  }

  void linksThatIdleBesideAState() {
    const StaticsCase train(withIdler());
    StaticsOptions options = lossy({95, 100});
    options.state = 0;
    const StaticsReport report = reportOf(train, options);
    QCOMPARE(*report.ratio, Rational(7, 2));
    QVERIFY(report.motion && report.isAnswered());
    QCOMPARE(*train.balance(report.solution(), 0).fraction(), Rational(-521, 160));
    QCOMPARE(*report.sums->efficiency()->fraction(), Rational(521, 160) / Rational(7, 2));
    QVERIFY(report.rateOf(0) && !report.rateOf(3) && !report.rateOf(4));
    // With the second sun held the ratio is the same: the second set idles, now at a known speed.
    options.state = 1;
    const StaticsReport held = reportOf(train, options);
    QVERIFY(held.idleMotion.empty() && held.ratio == report.ratio);
    QVERIFY(held.sums->efficiency() == report.sums->efficiency());
    // A load on a link that turns freely is held by nothing.
    options.state = 0;
    options.loads = {onLink("4", 1)};
    const auto codes = codesOf(reportOf(train, options).diagnostics);
    QVERIFY(std::find(codes.begin(), codes.end(), Code::unbalanced) != codes.end());
  }

  /// Issue 45: 100 N m on link 1, but reverse is driven by link 2.
  void everyStateHasItsOwnDrive() {
    Mechanism train = example("ravigneaux");
    train.loads = {onLink("1", 100)};
    const auto brakeInReverse = [](const StaticsCase& box, const Rational& efficiency) {
      const StateForces state = shiftOf(box, lossy(efficiency)).back();
      return *box.coupling(state.report->solution(), "B2").fraction();
    };
    const StaticsCase loaded(train);
    QCOMPARE(brakeInReverse(loaded, 1), Rational(-300));
    QCOMPARE(brakeInReverse(loaded, {98, 100}), Rational(-29208, 100));  // 100 (1 + 2 * 0.98^2)
    train.loads.clear();
    train.driveTorque = Number(Rational(100));
    QCOMPARE(brakeInReverse(StaticsCase(train), {98, 100}), Rational(-29208, 100));
    train.driveTorque.reset();
    QCOMPARE(brakeInReverse(StaticsCase(train), {98, 100}), Rational(-29208, 10000));
    // The load gives its size to all drives, and is named.
    const auto states = shiftOf(loaded, lossy({98, 100}));
    QCOMPARE(states.back().report->leftOut.size(), std::size_t{1});
    const auto ends = endTorques(loaded.mechanism, *states.back().report);
    QVERIFY(ends && ends->drive == Real(100) && ends->driven == Real(Rational(19208, 100)));
    QVERIFY(ends->otherLoads.empty());
  }

  void theEfficiencyIsOfTheState() {
    Mechanism train = example("ravigneaux");
    const auto efficiencies = [](const Mechanism& mechanism) {
      std::vector<Rational> all;
      for (const StateForces& state : shiftOf(StaticsCase(mechanism), lossy({98, 100})))
        all.push_back(efficiencyOf(state));
      return all;
    };
    const std::vector<Rational> own = efficiencies(train);
    QCOMPARE(own.back(), Rational(9604, 10000));
    for (const int size : {1, -7, 1000}) {
      train.loads = {onLink("1", size)};
      QCOMPARE(efficiencies(train), own);
      train.loads = {onLink("6", size), onLink("1", 3)};
      train.driveTorque = Number(Rational(size));
      QCOMPARE(efficiencies(train), own);
      train.driveTorque.reset();
    }
    // Other loads act on the torques all the same.
    const auto states = shiftOf(StaticsCase(train), lossy({98, 100}));
    const auto ends = endTorques(train, *states.front().report);
    QVERIFY(ends && ends->otherLoads.size() == 1 && ends->drive == Real(3));
  }

  /// Loads on driven links alone: the drive holds them, as before.
  void aLoadOnTheDrivenLink() {
    Mechanism train = example("ravigneaux");
    train.loads = {onLink("3", 24)};
    const auto states = shiftOf(StaticsCase(train), {});
    const auto ends = endTorques(train, *states.front().report);
    QVERIFY(ends && ends->driven == Real(24) && ends->drive == Real(-10));
    QVERIFY(states.front().report->leftOut.empty());
  }
};

QTEST_APPLESS_MAIN(AnsweredStaticsTest)
#include "test_answered_statics.moc"
