#include <QTest>

#include "core/machine/body_layout/complete_train.h"
#include "core/mechanism/document_format/mechanism_file.h"
#include "core/mechanism/model/edits.h"
#include "core/mechanism/model/validate.h"
#include "core/theory/analysis/analysis.h"
#include "core/theory/matroid/exact_solution.h"
#include "core/theory/ttgraph/tt_solution.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/tt_case.h"

namespace geargraph {
namespace {

/// What an example's notes promise for its own inputs: label of the joint, rate. `diagnostics` are the codes
/// that the analysis and the gears report.
struct Promise {
  const char* example;
  int freedoms;
  int redundant;
  std::vector<std::pair<int, Rational>> rates;
  std::vector<Code> diagnostics = {};
};

const std::vector<Promise>& promises() {
  static const std::vector<Promise> all{
      {"robot",
       3,
       0,
       {{10, Rational(-1, 2)}, {12, Rational(-2, 3)}, {13, Rational(-8, 9)}, {14, Rational(-16, 27)}}},
      {"spur-pair", 1, 0, {{4, Rational(-2, 3)}}},
      {"planetary-ring-held", 1, 0, {{5, Rational(2, 7)}, {6, Rational(-20, 21)}}},
      {"reverted-train", 1, 0, {{5, Rational(-1, 6)}, {6, Rational(1, 18)}}},
      {"three-planets", 1, 2, {{7, Rational(2, 7)}, {9, Rational(-20, 21)}}, {Code::redundantMesh}},
      {"cannot-be-assembled",
       1,
       2,
       {{7, Rational(1, 4)}, {9, Rational(-3, 4)}},
       {Code::redundantMesh, Code::assembly, Code::assembly}},
      {"redundant-planetary",
       2,
       4,
       {{11, 0}, {12, Rational(-16, 9)}, {16, Rational(-16, 9)}},
       {Code::redundantMesh}},
      {"ferguson-paradox", 1, 0, {{8, Rational(-1, 99)}, {9, 0}, {10, Rational(1, 101)}}, {Code::deadJoint}},
      {"bevel-differential", 2, 1, {{8, Rational(1, 2)}}, {Code::redundantMesh}},
      {"humpage-reduction", 1, 0, {{6, Rational(5, 24)}, {8, Rational(17, 1176)}}},
      {"ravigneaux", 2, 0, {{9, Rational(5, 12)}, {8, Rational(-5, 6)}}},
      {"simpson", 2, 0, {{9, Rational(75, 183)}, {7, Rational(-75, 33) * Rational(75, 183)}}},
      {"eight-speed-gearbox", 4, 0, {{17, Rational(3, 2)}, {20, Rational(23, 108)}}},
      {"prius-power-split", 3, 0, {{10, 204}, {13, Rational(-1740, 11)}, {18, Rational(15552, 847)}}},
      {"locked-train", 0, 0, {{4, 0}, {5, 0}, {6, 0}}, {Code::locked}},
      {"bevel-wrist", 3, 0, {{9, Rational(2, 3)}, {11, 0}, {12, Rational(-8, 9)}}},
      {"helical-reverted-train", 1, 0, {{5, Rational(-1, 6)}, {6, Rational(1, 18)}}},
      {"worm-hoist", 1, 0, {{5, Rational(1, 40)}, {6, Rational(-1, 160)}}},
      {"hoist-reducer", 1, 0, {{6, Rational(-8, 23)}, {8, Rational(-152, 6785)}}},
      {"three-speed-hub", 1, 0, {{5, Rational(4, 3)}}},
      {"three-roll-wrist", 3, 0, {{9, Rational(-4, 5)}, {11, 0}, {12, Rational(-2, 3)}}},
      {"guided-vehicle", 1, 0, {{10, Rational(39, 8000)}}},
      {"mantel-clock", 1, 0, {{8, 60}, {10, Rational(1, 12)}}, {Code::interference}},
      {"one-hand-clock",
       1,
       0,
       {{8, -960}},
       {Code::undercut, Code::interference, Code::undercut, Code::interference, Code::interference,
        Code::interference}},
      {"antikythera", 1, 0, {{14, Rational(-254, 19)}, {17, Rational(-5, 19)}, {20, Rational(-940, 4237)}}},
      {"strain-wave", 1, 0, {{5, Rational(-35, 34)}, {6, Rational(-1, 34)}}, {Code::interference}},
      {"cycloidal-drive",
       1,
       0,
       {{5, Rational(-16, 15)}, {6, Rational(-1, 15)}},
       {Code::undercut, Code::interference}},
      {"puma-wrist", 3, 0, {{14, 0}, {15, Rational(-13, 935)}, {16, Rational(13, 72) * Rational(13, 935)}}},
  };
  return all;
}

/// The example that is wrong on purpose; it promises nothing but its mistakes.
constexpr const char* kToMend = "robot-to-mend";

QStringList codesOf(const Diagnostics& diagnostics) {
  QStringList codes;
  for (const Diagnostic& diagnostic : diagnostics) {
    const std::string_view name = codeName(diagnostic.code);
    codes << QString::fromUtf8(name.data(), qsizetype(name.size()));
  }
  return codes;
}

SnapshotPtr analyzed(const Mechanism& mechanism) {
  return analyzeLive(std::make_shared<const Mechanism>(mechanism));
}

/// A gear of the eight-speed gearbox. What is engaged drives the four inputs (input shaft, suns 1 and 2, ring
/// 1, ring 3 with sun 4) at these speeds; `ratio` is as published.
struct Shift {
  const char* state;
  std::vector<Rational> speeds;
  double ratio;
};

const std::vector<Shift>& shifts() {
  static const std::vector<Shift> all{
      {"1", {1, 0, 0, 1}, 4.6957},
      {"2", {1, 0, 0, Rational(3, 2)}, 3.1304},
      {"3", {1, 1, 0, 1}, 2.1039},
      {"4", {1, Rational(9, 5), 0, Rational(3, 5)}, 1.6667},
      {"5", {1, Rational(3171, 1471), 0, 1}, 1.2845},
      {"6", {1, 1, 1, 1}, 1},
      {"7", {1, 0, Rational(3171, 1700), 1}, 0.8392},
      {"8", {1, 0, Rational(9, 4), Rational(3, 2)}, 0.6667},
      {"R", {1, 0, 0, Rational(-621, 436)}, -3.2968},
  };
  return all;
}

}  // namespace

/// The files that come with the program: each is there, written as the program writes, free of errors, and
/// moves as its notes say.
class ExamplesTest : public QObject {
  Q_OBJECT

 private slots:
  void everyFileIsPromised() {
    std::vector<std::string> promised{kToMend};
    for (const Promise& promise : promises()) promised.emplace_back(promise.example);
    std::sort(promised.begin(), promised.end());
    QCOMPARE(test::exampleNames(), promised);
  }

  void examplesMoveAsTheirNotesSay_data() {
    QTest::addColumn<int>("index");
    int index = 0;
    for (const Promise& promise : promises()) QTest::newRow(promise.example) << index++;
  }

  void examplesMoveAsTheirNotesSay() {
    QFETCH(int, index);
    const Promise& promise = promises()[static_cast<std::size_t>(index)];
    const std::string bytes = test::exampleText(promise.example);
    const Expected<Mechanism> read = readMechanism(bytes);
    QVERIFY(read.has_value());
    QCOMPARE(QString::fromStdString(writeMechanism(*read)), QString::fromStdString(bytes));
    QVERIFY(!read->notes.empty());
    QVERIFY(treeDiagnostics(*read).empty());

    const SnapshotPtr snapshot = analyzed(*read);
    QVERIFY(snapshot->matroid() != nullptr);
    QCOMPARE(snapshot->matroid()->dof, promise.freedoms);
    QCOMPARE(snapshot->matroid()->rank, read->c() - promise.redundant);
    Diagnostics promised;
    for (const Code code : promise.diagnostics) promised.push_back({code, {}, {}, {}, 0, 0});
    Diagnostics diagnostics = snapshot->diagnostics;
    append(diagnostics, trainDiagnostics(*read, snapshot->kinematics->placement()));
    QCOMPARE(codesOf(diagnostics), codesOf(promised));

    const test::TtCase found(*read);
    for (const Diagnostic& diagnostic : found.placement.diagnostics)
      qWarning("%s", diagnostic.message.c_str());
    QVERIFY(found.placement.diagnostics.empty());
    QVERIFY(found.graph.diagnostics().empty());
    const SubstitutionPlan plan = substitutionPlan(found.graph, found.inputs());
    const TtDetermination determination = ttDetermination(found.graph, plan).value();
    QVERIFY(determination.valid());
    QCOMPARE(static_cast<int>(plan.inputs.size()), promise.freedoms);
    QCOMPARE(static_cast<int>(determination.surplusEquations.size()), promise.redundant);
    const std::vector<Rational> rates = ttRates(found.graph, plan, found.speeds()).value();
    for (const auto& [label, rate] : promise.rates) {
      const auto joint = static_cast<std::size_t>(label - read->jointLabel(0));
      QCOMPARE(rates[joint].toString(), rate.toString());
    }
  }

  void theEightSpeedGearboxHasThePublishedRatios() {
    const Mechanism gearbox = test::example("eight-speed-gearbox");
    QCOMPARE(gearbox.states.size(), shifts().size());
    const SnapshotPtr snapshot = analyzed(gearbox);
    for (std::size_t i = 0; i < shifts().size(); ++i) {
      const Shift& shift = shifts()[i];
      QCOMPARE(gearbox.states[i].name, std::string(shift.state));
      const auto solution =
          solveExact(*snapshot->kinematics->model, snapshot->matroid()->choice.joints, shift.speeds);
      QVERIFY(solution.has_value());
      // The first eight joints tie links 1..8 to the ground.
      const auto speedOf = [&](LinkId link) {
        for (std::size_t joint = 0; joint < gearbox.turningJoints.size(); ++joint) {
          if (gearbox.turningJoints[joint].head == link) return solution->rates[joint];
        }
        return Rational(0);
      };
      for (const ShiftElementId engaged : gearbox.states[i].engaged) {
        const ShiftElement& coupling = *gearbox.find(engaged);
        const Rational held = coupling.kind == ShiftElementKind::brake ? 0 : speedOf(coupling.links[1]);
        QCOMPARE(speedOf(coupling.links[0]).toString(), held.toString());
      }
      const Rational ratio = speedOf(*gearbox.states[i].drive) / speedOf(*gearbox.states[i].driven);
      QVERIFY2(std::abs(ratio.toDouble() - shift.ratio) < 0.5e-4, ratio.toString().c_str());
    }
  }

  void theRobotToMendIsRepairedOneDiagnosticAfterAnother() {
    const std::string bytes = test::exampleText(kToMend);
    Mechanism wrong = readMechanism(bytes).value();
    QCOMPARE(QString::fromStdString(writeMechanism(wrong)), QString::fromStdString(bytes));
    QCOMPARE(codesOf(analyzed(wrong)->diagnostics), QStringList{QStringLiteral("turning-loop")});

    const ElementId bearing = wrong.turningJoints.back().id;
    wrong = withoutElements(wrong, std::vector{bearing}).value();
    QCOMPARE(codesOf(analyzed(wrong)->diagnostics), QStringList{QStringLiteral("teeth-geometry")});

    wrong = withTeeth(wrong, wrong.gearMeshes[1].id, 20, 30).value();
    QCOMPARE(codesOf(analyzed(wrong)->diagnostics), QStringList{QStringLiteral("invalid-inputs")});

    std::vector<Input> inputs = *wrong.inputs;
    inputs[1].joint = wrong.turningJoints[1].id;
    wrong = withInputs(wrong, inputs).value();
    QVERIFY(analyzed(wrong)->diagnostics.empty());

    const Mechanism robot = test::example("robot");
    wrong.name = robot.name;
    wrong.notes = robot.notes;
    QVERIFY(wrong == robot);
  }
};

}  // namespace geargraph

QTEST_APPLESS_MAIN(geargraph::ExamplesTest)
#include "test_examples.moc"
