#include <QTest>

#include "core/theory/matroid/exact_solution.h"
#include "core/theory/matroid/symbolic_solution.h"
#include "tests/core/support/matroid_fixture.h"
#include "tests/core/support/train_sketch.h"
#include "tests/core/support/trains.h"

using namespace geargraph;
using namespace geargraph::test;

namespace {

std::vector<Rational> ones(std::size_t count) {
  return std::vector<Rational>(count, Rational(1));
}

/// Angular speeds about z of the links 1, 2, ... for one driven joint.
std::vector<Rational> ratesOf(const Mechanism& mechanism) {
  const Worked worked(mechanism);
  return solveExact(worked.model, worked.analysis.choice.joints, worked.analysis.speeds)->rates;
}

/// The planetary of sun 1, ring 2 and carrier 3 (joints 5, 6, 7) with one of them held and one driven.
Mechanism planetaryDriven(int held, int driven) {
  Mechanism train = planetary(24, 18);
  train.inputs = std::vector<Input>{{JointId(std::to_string(4 + driven)), Number(1), {}},
                                    {JointId(std::to_string(4 + held)), Number(0), {}}};
  return train;
}

}  // namespace

class MatroidSolutionTest : public QObject {
  Q_OBJECT
 private slots:
  void planetaryWithTheRingHeld() {  // sun 24, ring 60: carrier turns 24/84
    QCOMPARE(ratesOf(planetaryDriven(2, 1))[2], Rational(24, 84));
  }
  void planetaryWithTheSunHeld() { QCOMPARE(ratesOf(planetaryDriven(1, 2))[2], Rational(60, 84)); }
  void planetaryWithTheCarrierHeld() { QCOMPARE(ratesOf(planetaryDriven(3, 1))[1], Rational(-24, 60)); }

  /// 1 drives 3 by 20/40, 3 drives 2 by 20/40; 2 turns on the line of 1, which its own axis names the other
  /// way round: it turns as 1 does in space, so against its axis.
  void anAxisThatPointsAgainstTheOneItLiesOnIsMinded() {
    TrainSketch train(3);
    train.axis("a", {"0", "0", "0"}).axis("b", {"0", "0", "0"}, {"0", "0", "-1"}).axis("c", {"60", "0", "0"});
    train.joint(0, 1, "a").joint(0, 2, "b").joint(0, 3, "c");
    train.mesh(1, 3, 20, 40).mesh(3, 2, 20, 40).inputs({{4, "1"}});
    const Worked worked(train.build());
    const auto solution = solveExact(worked.model, worked.analysis.choice.joints, worked.analysis.speeds);
    QCOMPARE(solution->rates, (std::vector<Rational>{1, Rational(-1, 4), Rational(-1, 2)}));
    QVERIFY(worked.analysis.linkVelocities[2] == (Vector3{0, 0, 0.25}));
    const CoefficientMatrix matrix(worked.mechanism, worked.model, worked.placement);
    for (int mesh = 0; mesh < 2; ++mesh) {
      double sum = 0;
      Rational normalised;
      for (const CoefficientMatrix::Entry& entry : matrix.row(mesh)) {
        sum += entry.length * solution->rates[static_cast<std::size_t>(entry.joint)].toDouble();
        normalised += Rational(entry.sign) * (entry.tail ? matrix.ratio(mesh) : Rational(1)) *
                      solution->rates[static_cast<std::size_t>(entry.joint)];
      }
      QCOMPARE(sum, 0.0);
      QVERIFY(normalised.isZero());
    }
  }

  void fergusonsParadox() {
    // One planet 20 meshes with wheels 100, 99 and 101 on the axis of the carrier; the 100 is held.
    TrainSketch train(5);
    train.joint(0, 1, "a").joint(0, 2, "a").joint(0, 3, "a").joint(0, 4, "a").joint(4, 5, "b");
    train.mesh(1, 5, 100, 20).mesh(2, 5, 99, 20).mesh(3, 5, 101, 20);
    train.inputs({{9, "1"}, {6, "0"}});
    const auto rates = ratesOf(train.build());
    QCOMPARE(rates[1], Rational(-1, 99));
    QCOMPARE(rates[2], Rational(1, 101));
  }

  void aDifferentialSplitsItsCarriersSpeed() {
    TrainSketch train(4);
    train.joint(0, 1, "a").joint(0, 2, "a").joint(0, 3, "a").joint(3, 4, "b");
    train.mesh(1, 4, 20, 15, MeshKind::bevel).mesh(4, 2, 15, 20, MeshKind::bevel);
    train.inputs({{5, "3"}, {7, "1"}});
    QCOMPARE(ratesOf(train.build())[1], Rational(-1));  // 2 w_c = w_1 + w_2
  }

  void theInputsOfTheDocumentAreTheColumns() {
    Mechanism swapped = robot();
    std::swap((*swapped.inputs)[0], (*swapped.inputs)[2]);
    const Worked worked(swapped);
    QVERIFY(worked.analysis.choice.joints == (std::vector<int>{3, 1, 0}));
    QVERIFY(worked.analysis.solution->outputs == (std::vector<int>{2, 4, 5, 6}));
  }

  void withoutInputsAValidSetIsChosenInTheOrderOfLabels() {
    Mechanism open = robot();
    open.inputs.reset();
    const Worked worked(open);
    QVERIFY(!worked.analysis.inputsGiven);
    QVERIFY(worked.analysis.choice.joints == (std::vector<int>{0, 1, 3}));  // 8, 9 and 11, as in the paper
    QVERIFY(worked.analysis.solution.has_value());
  }

  void aRatioThatMakesAMeshRedundantForTheseTeethOnlyIsSolvedInSymbolsToo() {
    // Two pairs 20:40 and 30:60 between the same two shafts.
    const Worked worked(
        TrainSketch(2).joint(0, 1, "a").joint(0, 2, "b").mesh(1, 2, 20, 40).mesh(1, 2, 30, 60).build());
    QCOMPARE(worked.analysis.rank, 1);
    const CoefficientMatrix matrix(worked.mechanism, worked.model, worked.placement);
    const auto symbolic = solveSymbolic(worked.mechanism, worked.model, matrix,
                                        worked.analysis.independentMeshes, worked.analysis.choice.joints);
    QCOMPARE(QString::fromStdString(symbolic->matrix[0]->toText()), "-i5");
  }

  void entriesOverTheBudgetAreCountedAndTheLinesSayThem() {
    // A chain of planetary stages: carrier of one drives sun of the next, both rings free to turn.
    const int stages = 5;
    TrainSketch train(4 * stages);
    for (int s = 0; s < stages; ++s) {
      const int sun = s == 0 ? 1 : 4 * s - 1;
      if (s == 0) train.joint(0, 1, "a");
      const int ring = 4 * s + 2;
      const int carrier = 4 * s + 3;
      const int planet = 4 * s + 4;
      train.joint(0, ring, "a").joint(0, carrier, "a").joint(carrier, planet, "p" + std::to_string(s));
      if (s > 0) train.joint(0, 4 * s + 1, "a");
      train.mesh(sun, planet, 20, 15, MeshKind::external).mesh(planet, ring, 15, 50, MeshKind::internal);
    }
    const Worked worked(train.build());
    const CoefficientMatrix matrix(worked.mechanism, worked.model, worked.placement);
    const auto all = solveSymbolic(worked.mechanism, worked.model, matrix, worked.analysis.independentMeshes,
                                   worked.analysis.choice.joints);
    const auto few = solveSymbolic(worked.mechanism, worked.model, matrix, worked.analysis.independentMeshes,
                                   worked.analysis.choice.joints, {}, {3});
    QCOMPARE(all->skipped, 0);
    QVERIFY(few->skipped > 0);
    QCOMPARE(few->lines.size(), few->outputs.size());
    for (std::size_t i = 0; i < few->matrix.size(); ++i) {
      if (few->matrix[i]) QVERIFY(*few->matrix[i] == *all->matrix[i]);
    }
  }

  void aStopEndsEverySolution() {
    const Worked worked(robot());
    std::stop_source stop;
    stop.request_stop();
    const CoefficientMatrix matrix(worked.mechanism, worked.model, worked.placement);
    QVERIFY(!analyzeMatroid(worked.mechanism, worked.model, worked.placement, stop.get_token()));
    QVERIFY(!solveExact(worked.model, worked.analysis.choice.joints, ones(3), stop.get_token()));
    QVERIFY(!solveSymbolic(worked.mechanism, worked.model, matrix, worked.analysis.independentMeshes,
                           worked.analysis.choice.joints, stop.get_token()));
  }
};

QTEST_APPLESS_MAIN(MatroidSolutionTest)
#include "test_matroid_solution.moc"
