#include <QTest>

#include "core/mechanism/model/load_edits.h"
#include "core/theory/statics/load_diagnostics.h"
#include "core/theory/statics/statics_report.h"
#include "tests/core/support/diagnostic_codes.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/gearboxes.h"
#include "tests/core/support/statics_case.h"
#include "tests/core/support/train_sketch.h"
#include "tests/core/support/trains.h"

using namespace geargraph;
using namespace geargraph::test;

namespace {

std::string messageOf(const StaticsReport& report, Code code) {
  for (const Diagnostic& diagnostic : report.diagnostics)
    if (diagnostic.code == code) return diagnostic.message;
  return {};
}

Load inJoint(const char* joint, const char* torque) {
  return {{}, JointTorque{JointId(joint), *Number::fromText(torque)}};
}

StaticsOptions loaded(std::vector<Load> loads) {
  StaticsOptions options;
  options.loads = std::move(loads);
  return options;
}

}  // namespace

class StaticsReportTest : public QObject {
  Q_OBJECT

 private slots:
  void everyExampleAgreesByBothMethods() {
    for (const std::string& name : exampleNames()) {
      if (name == "robot-to-mend") continue;
      const StaticsCase train(example(name));
      StaticsOptions options;
      for (const TurningJoint& joint : train.mechanism.turningJoints)
        options.loads.push_back({{}, JointTorque{joint.id, Number(7)}});
      for (std::size_t link = 1; link < train.mechanism.links.size(); ++link)
        options.loads.push_back({{}, LinkTorque{train.mechanism.links[link].id, {}, Number(3)}});
      for (const TurningJoint& joint : train.mechanism.turningJoints)
        if (std::find(train.analysis.choice.joints.begin(), train.analysis.choice.joints.end(),
                      &joint - train.mechanism.turningJoints.data()) != train.analysis.choice.joints.end())
          options.balances.push_back({joint.id, {}});
      const StaticsReport report = reportOf(train, options);
      QVERIFY2(report.agreement && report.agreement->equal, name.c_str());
      QVERIFY2(report.lossless.isBalanced(), name.c_str());
      for (int state = 0; state < static_cast<int>(train.mechanism.states.size()); ++state) {
        StaticsOptions shifted;
        shifted.state = state;
        const StaticsReport gear = reportOf(train, shifted);
        QVERIFY(gear.lossless.isBalanced() && gear.agreement->equal);
      }
    }
  }

  void inputsWithoutALoadOfTheirOwnHold() {
    const StaticsCase train(robot());
    const StaticsReport report = reportOf(train, loaded({inJoint("14", "10"), inJoint("8", "1")}));
    QCOMPARE(report.balancedJoints, (std::vector{1, 3}));
    QCOMPARE(codesOf(report.diagnostics), std::vector{Code::unbalanced});
    QCOMPARE(
        messageOf(report, Code::unbalanced),
        std::string("Nothing holds this motion: joints 8, 10, 12, 13 and 14 turn freely under the load on "
                    "joint 14 and joint 8. Add a balance at joint 10, 12 or 13."));
  }

  void aUnitLoadOnTheDrive() {
    const StaticsCase train(eightSpeed());
    StaticsOptions options;
    options.state = 0;
    const StaticsReport report = reportOf(train, options);
    QCOMPARE(codesOf(report.diagnostics), std::vector{Code::unitLoad});
    QCOMPARE(*train.balance(report.lossless, 0).fraction(), Rational(-108, 23));
    // A load on the output: the drive is the balance.
    options.loads = {{{}, LinkTorque{LinkId("2"), {}, Number(-108)}}};
    const StaticsReport pulled = reportOf(train, options);
    QVERIFY(codesOf(pulled.diagnostics).empty());
    QCOMPARE(*train.balance(pulled.lossless, 0).fraction(), Rational(23));
    QVERIFY(pulled.sums->fed == Real(23) && pulled.sums->taken == Real(23));
  }

  void aStateThatIsFreeHasNoMotion() {
    Mechanism gearbox = eightSpeed();
    gearbox.states[0].engaged.pop_back();
    const StaticsCase train(gearbox);
    StaticsOptions options;
    options.state = 0;
    const auto codes = codesOf(reportOf(train, options).diagnostics);
    QVERIFY(std::find(codes.begin(), codes.end(), Code::noMotion) != codes.end());
    QVERIFY(std::find(codes.begin(), codes.end(), Code::unbalanced) != codes.end());
  }

  void aLoadInADeadJoint() {
    const StaticsCase train(example("locked-train"));
    const JointId joint = train.mechanism.turningJoints[0].id;
    const StaticsReport report = reportOf(train, loaded({{{}, JointTorque{joint, Number(5)}}}));
    QVERIFY(report.lossless.isBalanced());
    const std::string message = messageOf(report, Code::deadLoad);
    QVERIFY2(message.find("cannot turn: its load is carried by mesh") != std::string::npos, message.c_str());
  }

  void sharedLoadsAreNamed() {
    Mechanism set = planetary(24, 18, 3);
    set.inputs = std::vector<Input>{{set.turningJoints[1].id, Number(0), {}},
                                    {set.turningJoints[2].id, Number(1), {}}};
    const StaticsCase train(set);
    const StaticsReport report =
        reportOf(train, loaded({{{}, JointTorque{set.turningJoints[0].id, Number(1)}}}));
    QCOMPARE(messageOf(report, Code::staticallyIndeterminate),
             std::string("Meshes 13, 14, 15, 16, 17 and 18 share the load in proportions that stiffness and "
                         "clearance decide (2 self-stresses). Torques outside are determined."));
    StaticsOptions options = loaded({{{}, JointTorque{set.turningJoints[0].id, Number(1)}}});
    options.losses = true;
    options.efficiency = Rational(98, 100);
    options.sharing = LoadSharing::none;
    QCOMPARE(reportOf(train, options).lossy->outcome, LossySolution::Outcome::undecided);
    options.sharing = LoadSharing::stiffness;
    const StaticsReport shared = reportOf(train, options);
    QCOMPARE(shared.lossy->outcome, LossySolution::Outcome::solved);
    // Three planets lose what one does.
    const StaticsCase single([&] {
      Mechanism one = planetary(24, 18, 1);
      one.inputs = std::vector<Input>{{one.turningJoints[1].id, Number(0), {}},
                                      {one.turningJoints[2].id, Number(1), {}}};
      return one;
    }());
    StaticsOptions alone = loaded({{{}, JointTorque{single.mechanism.turningJoints[0].id, Number(1)}}});
    alone.losses = true;
    alone.efficiency = Rational(98, 100);
    QCOMPARE(shared.sums->efficiency()->number(), reportOf(single, alone).sums->efficiency()->number());
  }

  void missingDataIsReported() {
    const StaticsCase train(robot());
    QCOMPARE(codesOf(reportOf(train).diagnostics), std::vector{Code::noLoad});
    StaticsOptions options = loaded({inJoint("14", "1")});
    options.losses = true;
    QCOMPARE(codesOf(reportOf(train, options).diagnostics), std::vector{Code::noEfficiency});
    Mechanism strange = robot();
    strange.unit = "cubit";
    const StaticsCase odd(strange);
    options =
        loaded({inJoint("14", "1"), {{}, LinkForce{LinkId("3"), {Number(1), Number(2), Number(3)}, {}}}});
    const StaticsReport report = reportOf(odd, options);
    QCOMPARE(codesOf(report.diagnostics), std::vector{Code::unknownUnit});
    QVERIFY(report.forces.bearings.empty());
    QCOMPARE(*odd.balance(report.lossless, 0).fraction(), Rational(8, 27));  // the torque alone
  }

  /// Both routes give the same torque matrix in symbols, on every example that has one.
  void bothMethodsAgreeInSymbols() {
    int compared = 0;
    for (const std::string& name : exampleNames()) {
      if (name == "robot-to-mend") continue;
      const StaticsCase train(example(name));
      if (!train.analysis.solution || train.analysis.choice.joints.empty()) continue;
      std::vector<Load> loads;
      for (int joint = 0; joint < train.model.t(); ++joint) {
        const auto& inputs = train.analysis.choice.joints;
        if (std::find(inputs.begin(), inputs.end(), joint) == inputs.end())
          loads.push_back(
              {{},
               JointTorque{train.mechanism.turningJoints[static_cast<std::size_t>(joint)].id, Number(1)}});
      }
      const StaticsReport report = reportOf(train, loaded(loads));
      const auto agrees = report.agreesInSymbols();
      if (!agrees) continue;
      QVERIFY2(*agrees, name.c_str());
      QVERIFY(!report.symbolic->matrix.empty());
      ++compared;
    }
    QVERIFY2(compared >= 5, std::to_string(compared).c_str());
  }

  void recirculationIsReported() {
    // A carrier drives a sun beside a fixed one, nearly equal: the teeth pass far more than is fed.
    Mechanism mechanism = TrainSketch(3)
                              .joint(0, 1, "a")
                              .joint(0, 2, "a")
                              .joint(1, 3, "b")
                              .mesh(0, 3, 99, 101, MeshKind::external)
                              .mesh(3, 2, 100, 100, MeshKind::external)
                              .build();
    mechanism.inputs = std::vector<Input>{{mechanism.turningJoints[0].id, Number(1), {}}};
    const StaticsCase train(mechanism);
    const StaticsReport report =
        reportOf(train, loaded({{{}, JointTorque{mechanism.turningJoints[1].id, Number(1)}}}));
    // i0 / (i0 - 1) of the power fed crosses each mesh, i0 = 101/99.
    QVERIFY(messageOf(report, Code::recirculation).find("49.5 times") != std::string::npos ||
            messageOf(report, Code::recirculation).find("50.5 times") != std::string::npos);
    // Both meshes are on one planet: they are named together.
    const std::vector<Code> codes = codesOf(report.diagnostics);
    QCOMPARE(std::count(codes.begin(), codes.end(), Code::recirculation), std::ptrdiff_t{1});
  }

  /// A document's diagnostics are about its loads: without any there are none, whatever was solved beside it.
  void diagnosticsOfADocument() {
    Mechanism robot = example("robot");
    robot.balances = std::vector<HoldingTorque>{{JointId("8")}};
    QVERIFY(solvedLoadDiagnostics(robot, reportOf(StaticsCase(robot))).empty());
    robot = *withLoad(robot, inJoint("14", "10"));
    const Diagnostics diagnostics = solvedLoadDiagnostics(robot, reportOf(StaticsCase(robot)));
    QVERIFY(diagnostics.size() == 1 && diagnostics.front().code == Code::unbalanced);
    robot.balances.reset();
    StaticsOptions options;
    options.losses = true;  // no mesh has an efficiency
    QVERIFY(solvedLoadDiagnostics(robot, reportOf(StaticsCase(robot), options)).empty());
  }

  /// The errors and warnings of all states of a gearbox; those that states share once.
  void diagnosticsOfStates() {
    Mechanism gearbox = eightSpeed();
    gearbox.loads = {{{}, LinkTorque{LinkId("1"), {}, Number(1)}}};
    gearbox.balances = std::vector<HoldingTorque>{};
    const StaticsCase train(gearbox);
    std::vector<StaticsReport> reports;
    for (int state = 0; state < 9; ++state) {
      StaticsOptions options;
      options.state = state;
      reports.push_back(reportOf(train, options));
    }
    std::vector<const StaticsReport*> all(9, nullptr);
    QVERIFY(solvedLoadDiagnostics(gearbox, all).empty());
    for (const std::size_t state : {0U, 2U}) all[state] = &reports[state];
    all[1] = &reports[0];  // the same diagnostic
    const Diagnostics diagnostics = solvedLoadDiagnostics(gearbox, all);
    QCOMPARE(diagnostics.size(), std::size_t{2});
    QVERIFY2(diagnostics[0].message.starts_with("In states 1 and 2: nothing holds this motion"),
             diagnostics[0].message.c_str());
    QVERIFY(diagnostics[1].message.starts_with("In state 3: nothing holds"));
    QVERIFY(!diagnostics[0].elements.empty());
  }
};

QTEST_APPLESS_MAIN(StaticsReportTest)
#include "test_statics_report.moc"
