#include <QTest>
#include <algorithm>

#include "core/theory/analysis/analysis.h"
#include "tests/core/support/deep_train.h"
#include "tests/core/support/diagnostic_codes.h"
#include "tests/core/support/textbook_trains.h"
#include "tests/core/support/train_sketch.h"
#include "tests/core/support/trains.h"

namespace geargraph {
namespace {

using test::codesOf;
SnapshotPtr analysisOf(const Mechanism& mechanism) {
  return analyze(std::make_shared<const Mechanism>(mechanism));
}

long timesSaid(const AnalysisSnapshot& snapshot, Code code) {
  const std::vector<Code> codes = codesOf(snapshot.diagnostics);
  return std::count(codes.begin(), codes.end(), code);
}

}  // namespace

/// What the snapshot holds when both methods have spoken.
class AnalysisTest : public QObject {
  Q_OBJECT

 private slots:
  void theRobotIsSolvedByBothMethodsWithoutDiagnostics() {
    const SnapshotPtr snapshot = analysisOf(test::robot());
    QVERIFY(snapshot->diagnostics.empty());
    const SolvedKinematics& solved = *snapshot->solved;
    QVERIFY(solved.agreement->equal);
    QCOMPARE(solved.agreement->compared, 12LL);
    for (std::size_t row = 0; row < 4; ++row) {
      for (std::size_t column = 0; column < 3; ++column) {
        QCOMPARE(solved.symbolic->matrix[row * 3 + column]->toText(),
                 solved.ttSymbolic->entries[row][column]->toText());
      }
    }
    QCOMPARE(solved.ttSteps->size(), std::size_t(4));
  }

  void everyTextbookTrainAgrees() {
    for (const test::TextbookTrain& train : test::textbookTrains()) {
      const SnapshotPtr snapshot = analysisOf(train.mechanism);
      QVERIFY(snapshot->solved);
      QVERIFY(snapshot->solved->agreement->equal);
    }
  }

  /// Where wheels and bodies have no room is planned after the live part, which waits for none of it.
  void overlappingWheelsAreReportedWithTheSecondStep() {
    test::TrainSketch sketch(4);
    sketch.axis("a", {"0", "0", "0"}).axis("b", {"40", "0", "0"}).axis("c", {"0", "40", "0"});
    sketch.joint(0, 1, "a").joint(0, 2, "a").joint(0, 3, "b").joint(0, 4, "c");
    sketch.mesh(1, 3, 20, 20, MeshKind::external, {"20", "0", "0"});
    sketch.mesh(2, 4, 20, 20, MeshKind::external, {"0", "20", "0"});
    const SnapshotPtr live = analyzeLive(std::make_shared<const Mechanism>(sketch.build()));
    QCOMPARE(timesSaid(*live, Code::interference), 0L);
    const SnapshotPtr full = analyzeFully(live);
    QCOMPARE(timesSaid(*full, Code::interference), 4L);  // wheels, and the shafts of both planes
    const auto found = std::find_if(full->diagnostics.begin(), full->diagnostics.end(),
                                    [](const Diagnostic& d) { return d.detail == Detail::wheelsOverlap; });
    QVERIFY(found != full->diagnostics.end());
    QCOMPARE(found->severity(), Severity::warning);
    QCOMPARE(found->elements, (std::vector<ElementId>{LinkId("1"), LinkId("2")}));
    QVERIFY(full->solved);
  }

  void aMeshWithoutACarrierIsSaidOnce() {
    Mechanism robot = test::robot();
    robot.gearMeshes[0].tail = LinkId("5");  // coaxial with 1
    robot.gearMeshes[0].pitchPoint.reset();
    robot.gearMeshes[3].tail = LinkId("4");  // three axes from 3
    robot.gearMeshes[3].pitchPoint.reset();
    const SnapshotPtr snapshot = analysisOf(robot);
    QCOMPARE(codesOf(snapshot->diagnostics), (std::vector<Code>{Code::coaxialMesh, Code::noTransferVertex}));
    QVERIFY(snapshot->diagnostics[1].message.find("(a, b, c, e)") != std::string::npos);  // its path
    QVERIFY(!snapshot->solved);
  }

  void axesThatSplitOrMergeAreSaidOnce() {
    test::TrainBuilder train("three names, one line, and a bend");
    const int a = train.axis({0, 0, 0}, {0, 0, 1});
    const int b = train.axis({0, 0, 5}, {0, 0, -1});
    const int c = train.axis({0, 0, 9}, {0, 0, 3});
    const int bend = train.axis({0, 0, 0}, {0, 1, 0});
    const int first = train.link(0, a);
    train.link(0, b);
    train.link(0, c);
    const int second = train.link(first, bend);
    train.link(second, a);
    const SnapshotPtr snapshot = analysisOf(train.mechanism());
    std::vector<Code> geometry;
    for (const Code code : codesOf(snapshot->diagnostics)) {
      if (code == Code::splitAxis || code == Code::mergedAxes) geometry.push_back(code);
    }
    QCOMPARE(geometry, (std::vector<Code>{Code::splitAxis, Code::mergedAxes}));
  }

  /// A chain of planetary stages with fixed rings: every second stage has four times the terms.
  void anEntryOverItsBudgetIsLeftAsAChainAndSaid() {
    constexpr int kStages = 12;
    test::TrainSketch train(1 + 2 * kStages);
    train.joint(0, 1, "a");
    for (int stage = 0; stage < kStages; ++stage) {
      const int sun = 2 * stage + (stage == 0 ? 1 : 0);
      train.joint(0, 2 * stage + 2, "a").joint(2 * stage + 2, 2 * stage + 3, "p" + std::to_string(stage));
      train.mesh(sun, 2 * stage + 3, 20, 15, MeshKind::external);
      train.mesh(2 * stage + 3, 0, 15, 50, MeshKind::internal);
    }
    const SnapshotPtr snapshot = analysisOf(train.build());
    QCOMPARE(timesSaid(*snapshot, Code::symbolicSkipped), 1L);
    const SymbolicSolution& symbolic = *snapshot->solved->symbolic;
    QVERIFY(symbolic.skipped > 0);
    QCOMPARE(symbolic.lines.size(), symbolic.outputs.size());
    QVERIFY(snapshot->solved->agreement->equal);
  }

  /// Every entry is one product, of as many ratios as there are carriers below the joint.
  void theEntriesOfADeepTrainHaveOneBudgetTogether() {
    const SnapshotPtr snapshot = analysisOf(test::deepTrain(1, 1000));
    QCOMPARE(timesSaid(*snapshot, Code::symbolicSkipped), 1L);
    const SymbolicSolution& symbolic = *snapshot->solved->symbolic;
    std::int64_t size = 0;
    int given = 0;
    for (const auto& entry : symbolic.matrix) {
      if (!entry) continue;
      QVERIFY(entry->termCount() <= kExpansionBudget);
      size += entry->size();
      ++given;
    }
    QVERIFY2(size > kSolutionBudget / 4, qPrintable(QString::number(size)));
    QVERIFY2(size <= kSolutionBudget, qPrintable(QString::number(size)));
    QVERIFY(symbolic.skipped > 0);
    QCOMPARE(given + symbolic.skipped, static_cast<int>(symbolic.matrix.size()));
    QVERIFY(snapshot->solved->agreement->equal);
  }

  void moreSymbolsThanAnybodyReadsAreLeftOutAndSaid() {
    constexpr int kPairs = 150;
    test::TrainSketch train(2 * kPairs);
    for (int link = 1; link <= 2 * kPairs; ++link) train.joint(0, link, "a" + std::to_string(link));
    for (int pair = 0; pair < kPairs; ++pair) train.mesh(2 * pair + 1, 2 * pair + 2, 20, 30);
    const SnapshotPtr snapshot = analysisOf(train.build());
    QCOMPARE(timesSaid(*snapshot, Code::symbolicSkipped), 1L);
    QVERIFY(!snapshot->solved->symbolic);
    QVERIFY(snapshot->solved->agreement->equal);
  }

  /// Planetary sets between two dozen shafts, each tied to three far ones.
  void equationsThatAreTooCoupledForSymbolsAreSaid() {
    constexpr int kShafts = 24;
    test::TrainSketch train(2 * kShafts - 2);
    for (int shaft = 1; shaft <= kShafts; ++shaft) train.joint(0, shaft, "a");
    for (int set = 0; set < kShafts - 2; ++set) {
      const auto shaft = [&](int step) { return 1 + (set + step) % kShafts; };
      const int planet = kShafts + 1 + set;
      train.joint(shaft(7), planet, "p" + std::to_string(set));
      train.mesh(shaft(0), planet, 20 + set, 15, MeshKind::external);
      train.mesh(planet, shaft(3), 15, 50 + set, MeshKind::internal);
    }
    const SnapshotPtr snapshot = analysisOf(train.build());
    QCOMPARE(timesSaid(*snapshot, Code::symbolicSkipped), 1L);
    QVERIFY(!snapshot->solved->symbolic);
    QCOMPARE(snapshot->matroid()->dof, 2);
    QVERIFY(snapshot->solved->agreement->equal);
  }

  void aPitchPointOffItsPlaneIsStillSaid() {
    Mechanism robot = test::robot();
    robot.gearMeshes[1].pitchPoint = NumberTriple{Number(9), Number(-20), Number(30)};
    QCOMPARE(codesOf(analysisOf(robot)->diagnostics), (std::vector<Code>{Code::pitchGeometry}));
  }
};

}  // namespace geargraph

QTEST_APPLESS_MAIN(geargraph::AnalysisTest)
#include "test_analysis.moc"
