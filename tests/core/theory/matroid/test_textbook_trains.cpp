#include <QTest>

#include "core/theory/matroid/exact_solution.h"
#include "tests/core/support/matroid_fixture.h"
#include "tests/core/support/train_sketch.h"

using namespace geargraph;
using namespace geargraph::test;

namespace {

/// Rates by joint position, exactly, for the document's inputs.
std::vector<Rational> rates(const TrainSketch& train) {
  const Worked worked(train.build());
  if (!worked.analysis.solution) return {};
  return solveExact(worked.model, worked.analysis.choice.joints, worked.analysis.speeds)->rates;
}

/// Sun 1 (and 2), ring 3, carrier 4, planets 5 and 6; joints 7..12 in that order.
TrainSketch ravigneaux() {
  TrainSketch train(6);
  for (int link = 1; link <= 4; ++link) train.joint(0, link, "a");
  train.joint(4, 5, "long").joint(4, 6, "short");
  train.mesh(1, 6, 30, 18, MeshKind::external);  // small sun and short planet
  train.mesh(6, 5, 18, 20, MeshKind::external);  // short and long planet
  train.mesh(2, 5, 36, 20, MeshKind::external);  // large sun and long planet
  train.mesh(5, 3, 20, 76, MeshKind::internal);  // long planet and ring
  return train;
}

/// Two planetary sets with one sun, as in a three-speed automatic: sun 1, front ring 2 (input), output 3 =
/// front carrier and rear ring, rear carrier 4, planets 5 and 6; joints 7..12 in that order.
TrainSketch simpson() {
  TrainSketch train(6);
  for (int link = 1; link <= 4; ++link) train.joint(0, link, "a");
  train.joint(3, 5, "front").joint(4, 6, "rear");
  train.mesh(1, 5, 28, 17, MeshKind::external).mesh(5, 2, 17, 62, MeshKind::internal);
  train.mesh(1, 6, 28, 17, MeshKind::external).mesh(6, 3, 17, 62, MeshKind::internal);
  return train;
}

}  // namespace

class TextbookTrainsTest : public QObject {
  Q_OBJECT
 private slots:
  void ravigneauxWithTheCarrierHeldReversesTheLargeSun() {
    const auto q = rates(ravigneaux().inputs({{8, "1"}, {10, "0"}}));
    QCOMPARE(q[2], Rational(-36, 76));
  }
  void ravigneauxWithTheCarrierHeldReducesTheSmallSun() {
    const auto q = rates(ravigneaux().inputs({{7, "1"}, {10, "0"}}));
    QCOMPARE(q[2], Rational(30, 76));
  }
  void ravigneauxWithTheLargeSunHeldIsItsSecondGear() {
    // Willis twice: 76 (w3 - wc) = 30 (w1 - wc) and 76 (w3 - wc) = -36 (0 - wc), so w3/w1 = 112/76 : 66/30.
    const auto q = rates(ravigneaux().inputs({{7, "1"}, {8, "0"}}));
    QCOMPARE(q[2], Rational(112, 76) / Rational(66, 30));
  }

  void simpsonsFirstGearIs2_45() {
    const auto q = rates(simpson().inputs({{8, "1"}, {10, "0"}}));
    QCOMPARE(q[2].inverse(), Rational(62 + 28 + 62, 62));  // 2.4516
  }
  void simpsonsSecondGearIs1_45() {
    const auto q = rates(simpson().inputs({{8, "1"}, {7, "0"}}));
    QCOMPARE(q[2].inverse(), Rational(62 + 28, 62));  // 1.4516
  }
  void simpsonsReverseIsTheRingOverTheSun() {
    const auto q = rates(simpson().inputs({{7, "1"}, {10, "0"}}));
    QCOMPARE(q[2].inverse(), Rational(-62, 28));
  }

  void humpagesReductionGear() {
    // Input 1 and the fixed gear (the ground) hold the large wheel of planet 4 between them; its small wheel
    // drives output 2, on the fixed gear's side: w2/w1 = (1 - N0 N5/(N4 N2)) / (1 + N0/N1).
    const TrainSketch train = TrainSketch(4)
                                  .axis("a", {"0", "0", "0"})
                                  .axis("b", {"0", "0", "0"}, {"0", "1", "0"})
                                  .joint(0, 1, "a")
                                  .joint(0, 2, "a")
                                  .joint(0, 3, "a")
                                  .joint(3, 4, "b")
                                  .mesh(1, 4, 20, 56, MeshKind::bevel, {"0", "20", "-56"})
                                  .mesh(4, 0, 56, 76, MeshKind::bevel, {"0", "76", "56"})
                                  .mesh(4, 2, 24, 35, MeshKind::bevel, {"0", "35", "24"})
                                  .inputs({{5, "1"}});
    const auto q = rates(train);
    QCOMPARE(q[1], (Rational(1) - Rational(76 * 24, 56 * 35)) / (Rational(1) + Rational(76, 20)));
  }

  void aClockTurnsItsHandsOnceADayAndTwelveTimes() {
    // Motion work: minute hand 1, intermediate wheel and pinion 2, hour hand 3.
    const auto q = rates(TrainSketch(3)
                             .joint(0, 1, "a")
                             .joint(0, 2, "b")
                             .joint(0, 3, "a")
                             .mesh(1, 2, 12, 36)
                             .mesh(2, 3, 10, 40)
                             .inputs({{4, "12"}}));
    QCOMPARE(q[2], Rational(1));
  }

  void aBevelWristTurnsItsToolByTheDifferenceOfItsDrives() {
    // Carrier 1 (pitch) on axis a, drive wheel 2 on a too, tool 3 on axis b of the carrier.
    const auto q = rates(TrainSketch(3)
                             .axis("a", {"0", "0", "0"}, {"0", "1", "0"})
                             .axis("b", {"0", "0", "0"}, {"1", "0", "0"})
                             .joint(0, 1, "a")
                             .joint(0, 2, "a")
                             .joint(1, 3, "b")
                             .mesh(2, 3, 20, 10, MeshKind::bevel, {"20", "10", "0"})
                             .inputs({{4, "3"}, {5, "5"}}));
    QCOMPARE(q[2], Rational(-4));  // |2 (5 - 3)|; the wheel at +y turns the tool at +x against its axis
  }
};

QTEST_APPLESS_MAIN(TextbookTrainsTest)
#include "test_textbook_trains.moc"
