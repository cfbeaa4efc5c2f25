#include <QTest>
#include <set>

#include "core/theory/matroid/matroid_diagnostics.h"
#include "tests/core/support/matroid_fixture.h"
#include "tests/core/support/train_sketch.h"
#include "tests/core/support/trains.h"

using namespace geargraph;
using namespace geargraph::test;

namespace {

/// Wheels with these teeth on fixed axes in a ring, each meshing with the next and the last with the first.
Mechanism ringOfWheels(const std::vector<int>& teeth) {
  const int n = static_cast<int>(teeth.size());
  TrainSketch train(n);
  for (int i = 0; i < n; ++i) train.joint(0, i + 1, std::string(1, static_cast<char>('a' + i)));
  for (int i = 0; i < n; ++i) train.mesh(i + 1, (i + 1) % n + 1, teeth[i], teeth[(i + 1) % n]);
  return train.build();
}

std::vector<Code> codes(const MatroidAnalysis& analysis) {
  std::vector<Code> result;
  for (const Diagnostic& diagnostic : analysis.diagnostics) result.push_back(diagnostic.code);
  return result;
}

Diagnostic find(const MatroidAnalysis& analysis, Code code) {
  for (const Diagnostic& diagnostic : analysis.diagnostics) {
    if (diagnostic.code == code) return diagnostic;
  }
  return {};
}

/// Does the diagnostic state this relation or list of labels?
bool states(const Diagnostic& diagnostic, const char* value) {
  return diagnostic.message.find(value) != std::string::npos;
}

/// The ids of the diagnostic's elements, in order and without repetition.
QStringList blamed(const Diagnostic& diagnostic) {
  QStringList ids;
  for (const ElementId& element : diagnostic.elements) ids << QString::fromStdString(element.id.text());
  ids.removeDuplicates();
  return ids;
}

Mechanism withInputs(Mechanism mechanism, const std::vector<int>& labels) {
  mechanism.inputs.emplace();
  for (const int label : labels) {
    mechanism.inputs->push_back({JointId(std::to_string(label)), Number(1), {}});
  }
  return mechanism;
}

}  // namespace

class MatroidDiagnosticsTest : public QObject {
  Q_OBJECT
 private slots:
  void theRobotHasNoDiagnostics() {
    const Worked worked(robot());
    QVERIFY(worked.analysis.diagnostics.empty());
    QCOMPARE(worked.analysis.rank, 4);
    QCOMPARE(worked.analysis.dof, 3);
    QCOMPARE(worked.analysis.kutzbachDof, 3);
  }

  void ratiosAndSpeedsBeyondTheDoublesAreErrorsAndGiveNoNumbers() {
    constexpr int kShafts = 80;  // each ten thousand times faster than the one before
    TrainSketch train(kShafts);
    for (int i = 1; i <= kShafts; ++i) train.joint(0, i, "axis " + std::to_string(i));
    for (int i = 1; i < kShafts; ++i) train.mesh(i, i + 1, 100'000, 10);
    const Worked chain(train.inputs({{kShafts + 1, "1"}}).build());
    QVERIFY(!chain.analysis.solution && chain.analysis.linkVelocities.empty());
    const Diagnostic ratio = find(chain.analysis, Code::schema);
    QVERIFY(states(ratio, "joint 15"));  // to joint 158 it is 1e308
    QCOMPARE(ratio.elements.size(), std::size_t{1});

    Mechanism fast = robot();
    for (Input& input : *fast.inputs) input.speed = Number::fromText("1.7e308").value();
    const Worked worked(fast);
    QVERIFY(!worked.analysis.solution);
    QCOMPARE(find(worked.analysis, Code::schema).code, Code::schema);
    QCOMPARE(worked.analysis.rank, 4);
  }

  void planetsBeyondTheFirstAreRedundant() {
    for (int planets = 1; planets <= 5; ++planets) {
      const Worked worked(planetary(24, 18, planets));
      QCOMPARE(worked.analysis.rank, planets + 1);
      QCOMPARE(worked.analysis.dof, 2);
      QCOMPARE(worked.analysis.kutzbachDof, 3 - planets);
      QCOMPARE(static_cast<int>(worked.analysis.redundancies.size()), planets - 1);
    }
  }

  void theRedundantMeshIsTheLastOfItsLoopAndTheLoopIsNamed() {
    const Worked worked(planetary(24, 18, 2));
    QCOMPARE(worked.analysis.redundancies.front().equation, 3);
    QVERIFY(worked.analysis.redundancies.front().dependsOn == (std::vector<int>{0, 1, 2}));
    const Diagnostic diagnostic = find(worked.analysis, Code::redundantMesh);
    QCOMPARE(blamed(diagnostic), (QStringList{"14", "11", "12", "13"}));
  }

  /// What follows from equal planets is one note per set, after the others.
  void redundancyOfEqualPlanetsIsOneNote() {
    for (int planets = 2; planets <= 5; ++planets) {
      const Worked worked(planetary(24, 18, planets));
      QVERIFY(codes(worked.analysis) == std::vector<Code>{Code::redundantMesh});
      const Diagnostic note = find(worked.analysis, Code::redundantMesh);
      QCOMPARE(note.detail, Detail::equalPlanets);
      QCOMPARE(note.severity(), Severity::info);
      QCOMPARE(note.elements.size(), std::size_t(2 * planets));  // all meshes, the redundant ones first
    }
    const Worked three(planetary(24, 18, 3));
    QCOMPARE(
        find(three.analysis, Code::redundantMesh).message,
        std::string("Links 4, 5 and 6 are equal planets, which share the load: the motion would be the same "
                    "without meshes 16 and 18."));
    const Worked square(ringOfWheels({20, 30, 40, 25}));
    QCOMPARE(find(square.analysis, Code::redundantMesh).severity(), Severity::warning);
  }

  void aTriangleOfWheelsIsLocked() {
    const Worked worked(ringOfWheels({20, 30, 40}));
    QCOMPARE(worked.analysis.dof, 0);
    QVERIFY(codes(worked.analysis) == std::vector<Code>{Code::locked});
    QCOMPARE(blamed(find(worked.analysis, Code::locked)), (QStringList{"7", "8", "9"}));
    QVERIFY(worked.analysis.choice.joints.empty());
    QVERIFY(worked.analysis.solution.has_value());
  }

  void aSquareOfWheelsTurns() {
    const Worked worked(ringOfWheels({20, 30, 40, 25}));
    QCOMPARE(worked.analysis.dof, 1);
    QCOMPARE(worked.analysis.rank, 3);
    QVERIFY(codes(worked.analysis) == std::vector<Code>{Code::redundantMesh});
  }

  void twoPairsOfDifferentRatioOnTheSameShaftsLock() {
    const Worked worked(
        TrainSketch(2).joint(0, 1, "a").joint(0, 2, "b").mesh(1, 2, 20, 40).mesh(1, 2, 20, 41).build());
    QCOMPARE(worked.analysis.dof, 0);
    QCOMPARE(blamed(find(worked.analysis, Code::locked)), (QStringList{"5", "6"}));
  }

  void ratiosThatMissEachOtherByLessThanADoubleSeesLock() {
    // Round a ring of eight wheels the product of n (n-2)^6 (n-4) / ((n-1)^4 (n-3)^4) misses 1 by 6e-20.
    const int n = 100'000;
    const std::vector<int> tails{n, n - 2, n - 2, n - 2, n - 2, n - 2, n - 2, n - 4};
    std::vector<int> heads{n - 1, n - 1, n - 1, n - 1, n - 3, n - 3, n - 3, n - 3};
    const auto ring = [&] {
      TrainSketch train(8);
      for (int i = 0; i < 8; ++i) train.joint(0, i + 1, std::string(1, static_cast<char>('a' + i)));
      for (int i = 0; i < 8; ++i) train.mesh(i + 1, (i + 1) % 8 + 1, tails[i], heads[i]);
      return train.build();
    };
    QCOMPARE(Worked(ring()).analysis.dof, 0);
    heads = {n - 2, n - 2, n - 4, n - 2,
             n,     n - 2, n - 2, n - 2};  // the same counts in another order: exactly 1
    QCOMPARE(Worked(ring()).analysis.dof, 1);
  }

  void aLockedPartIsARigidBlockWhileTheRestMoves() {
    Mechanism train = ringOfWheels({20, 30, 40});
    train.links.push_back({LinkId("4"), {}});
    train.links.push_back({LinkId("5"), {}});
    for (const char* link : {"4", "5"}) {
      train.axes.push_back({AxisId(std::string("x") + link), {}, {}});
      train.turningJoints.push_back({JointId(std::string("j") + link),
                                     LinkId("0"),
                                     LinkId(link),
                                     AxisId(std::string("x") + link),
                                     Number(0),
                                     {}});
    }
    GearMesh free;
    free.id = MeshId("free");
    free.tail = LinkId("4");
    free.head = LinkId("5");
    train.gearMeshes.push_back(free);
    const Worked worked(train);
    QCOMPARE(worked.analysis.dof, 1);
    QVERIFY(worked.analysis.rigidBlocks == (std::vector<std::vector<int>>{{0, 1, 2, 3}}));
    const Diagnostic diagnostic = find(worked.analysis, Code::deadJoint);
    std::set<ElementId> expected;  // the dead joints, the locked loop, the rigid block
    for (std::size_t i = 0; i < 3; ++i) expected.insert(train.turningJoints[i].id);
    for (std::size_t i = 0; i < 3; ++i) expected.insert(train.gearMeshes[i].id);
    for (std::size_t i = 0; i < 4; ++i) expected.insert(train.links[i].id);
    QVERIFY(std::set(diagnostic.elements.begin(), diagnostic.elements.end()) == expected);
    QVERIFY(worked.analysis.choice.joints == std::vector<int>{3});
  }

  void aWheelHungToALockedLoopIsNoPartOfTheReason() {
    Mechanism train = ringOfWheels({20, 30, 40});
    train.links.push_back({LinkId("4"), {}});
    train.axes.push_back({AxisId("x"), {}, {}});
    train.turningJoints.push_back({JointId("j"), LinkId("0"), LinkId("4"), AxisId("x"), Number(0), {}});
    GearMesh hung;
    hung.id = MeshId("hung");
    hung.tail = LinkId("1");
    hung.head = LinkId("4");
    train.gearMeshes.push_back(hung);
    const Worked worked(train);
    QCOMPARE(worked.analysis.dof, 0);
    QCOMPARE(worked.analysis.lockedLoops.size(), std::size_t{1});
    QVERIFY(worked.analysis.lockedLoops.front().equations == (std::vector<int>{0, 1, 2}));
  }

  void aJointWithoutMeshesIsIdleAndAnInput() {
    const Worked worked(
        TrainSketch(3).joint(0, 1, "a").joint(0, 2, "b").joint(2, 3, "c").mesh(1, 2, 20, 30).build());
    QVERIFY(codes(worked.analysis) == std::vector<Code>{Code::idleJoint});
    QCOMPARE(blamed(find(worked.analysis, Code::idleJoint)), QStringList("6"));
    QVERIFY(worked.analysis.choice.joints == (std::vector<int>{0, 2}));
  }

  void withoutMeshesEveryJointIsFree() {
    const Worked worked(TrainSketch(3).joint(0, 1, "a").joint(1, 2, "a").joint(1, 3, "b").build());
    QVERIFY(codes(worked.analysis) == std::vector<Code>{Code::noMeshes});
    QCOMPARE(worked.analysis.dof, 3);
    QVERIFY(worked.analysis.choice.joints == (std::vector<int>{0, 1, 2}));
  }

  void dependentInputsAreRejectedWithTheirRelation() {
    const Worked worked(withInputs(robot(), {8, 10, 11}));
    QVERIFY(!worked.analysis.solution.has_value());
    const Diagnostic diagnostic = find(worked.analysis, Code::invalidInputs);
    QVERIFY(states(diagnostic, "q10 = -i15 q8"));
    QVERIFY(states(diagnostic, "8, 11 and 9"));
    QCOMPARE(diagnostic.elements.front(), ElementId(JointId("10")));
    QVERIFY(worked.analysis.choice.rejected == std::vector<int>{2});
    QVERIFY(worked.analysis.choice.added == std::vector<int>{1});
  }

  void theRelationBehindThePlanetsOfTheRobotIsThatOfEquation30() {
    const Worked worked(withInputs(robot(), {13, 14, 8}));
    QVERIFY(states(find(worked.analysis, Code::invalidInputs), "q14 = i18 q13"));
  }

  void tooFewInputsAreRejectedWithWhatIsStillFree() {
    const Worked worked(withInputs(robot(), {8, 11}));
    const Diagnostic diagnostic = find(worked.analysis, Code::invalidInputs);
    QCOMPARE(diagnostic.elements.front(), ElementId(JointId("9")));
    QCOMPARE(worked.analysis.dof, 3);
  }

  void tooManyInputsAreRejectedWithTheOneThatFollows() {
    const Worked worked(withInputs(robot(), {8, 9, 11, 12}));
    QVERIFY(states(find(worked.analysis, Code::invalidInputs), "q12 = -i16*i15 q8 - i16 q9"));
  }

  void oneJointChosenTwiceIsSaid() {
    const Worked worked(withInputs(robot(), {8, 8, 11}));
    QCOMPARE(find(worked.analysis, Code::invalidInputs).elements.front(), ElementId(JointId("8")));
    QVERIFY(worked.analysis.choice.rejected == std::vector<int>{0});
  }

  void aDeadInputIsRejected() {
    const Worked worked(withInputs(ringOfWheels({20, 30, 40}), {4}));
    const Diagnostic diagnostic = find(worked.analysis, Code::invalidInputs);
    QVERIFY(states(diagnostic, "q4 = 0"));
    QVERIFY(worked.analysis.choice.joints.empty());
  }
};

QTEST_APPLESS_MAIN(MatroidDiagnosticsTest)
#include "test_matroid_diagnostics.moc"
