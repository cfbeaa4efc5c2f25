#include <QTest>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/theory/states/state_solution.h"
#include "tests/core/support/gearboxes.h"
#include "tests/core/support/snapshot_of.h"
#include "tests/core/support/train_sketch.h"

using namespace geargraph;
using test::snapshotOf;
using test::TrainSketch;

namespace {

/// The rates of all joints, after both methods agreed on them.
ByJoint<Rational> machineRates(const Mechanism& mechanism) {
  const SnapshotPtr snapshot = snapshotOf(mechanism);
  if (hasErrors(snapshot->diagnostics)) throw std::runtime_error(snapshot->diagnostics.front().message);
  const SolvedKinematics& solved = *snapshot->solved;
  if (!solved.ttExact || !solved.agreement || !solved.agreement->equal || solved.agreement->compared == 0)
    throw std::runtime_error("the methods disagree");
  return solved.exact->rates;
}

Rational machineRate(const Mechanism& mechanism, int label) {
  return machineRates(mechanism)[label - mechanism.n() - 1];
}

/// A train on fixed axes: teeth of the driving and the driven wheel, pair by pair, from link 1 to the last.
Mechanism chainOf(const std::vector<std::pair<int, int>>& pairs) {
  const int links = static_cast<int>(pairs.size()) + 1;
  TrainSketch train(links);
  for (int link = 1; link <= links; ++link) train.joint(0, link, "x" + std::to_string(link));
  for (int i = 0; i + 1 < links; ++i)
    train.mesh(i + 1, i + 2, pairs[std::size_t(i)].first, pairs[std::size_t(i)].second, MeshKind::external);
  return train.inputs({{links + 1, "1"}}).build();
}

Rational ratioOf(const std::vector<std::pair<int, int>>& pairs) {
  return machineRates(chainOf(pairs)).back();
}

/// The wrist of the PUMA 560: links 1..3 are its three joints (4, 5 and 6 of the arm), 4..6 the motors.
Mechanism pumaWrist() {
  TrainSketch train(13);
  train
      .axis("a", {"0", "0", "0"})                      // joint 4, and motors 5 and 6
      .axis("w", {"0", "0", "400"}, {"0", "1", "0"})   // joint 5
      .axis("t", {"0", "0", "400"}, {"0", "0", "1"});  // joint 6
  train
      .joint(0, 1, "a")  // 14: q4
      .joint(1, 2, "w")  // 15: q5
      .joint(2, 3, "t")  // 16: q6
      .joint(0, 4, "m")  // 17: motor 4
      .joint(0, 5, "a")  // 18: motor 5
      .joint(0, 6, "a")  // 19: motor 6
      .joint(0, 7, "n")  // 20, 21: the shafts of motor 4
      .joint(0, 8, "o")
      .joint(1, 9, "p")  // 22, 23: those of motor 5
      .joint(1, 10, "q")
      .joint(1, 11, "r")  // 24, 25: those of motor 6
      .joint(1, 12, "s")
      .joint(1, 13, "w");  // 26: the idler on joint 5
  train.mesh(4, 7, 22, 68, MeshKind::external)
      .mesh(7, 8, 20, 82, MeshKind::external)
      .mesh(8, 1, 20, 120, MeshKind::external)
      .mesh(5, 9, 16, 68, MeshKind::external)
      .mesh(9, 10, 20, 80, MeshKind::external)
      .mesh(10, 2, 13, 55, MeshKind::bevel)
      .mesh(6, 11, 20, 60, MeshKind::external)
      .mesh(11, 12, 30, 30, MeshKind::external)
      .mesh(12, 13, 13, 60, MeshKind::bevel)
      .mesh(13, 3, 13, 72, MeshKind::bevel);
  return train.build();
}

}  // namespace

/// Machines with published tooth counts and ratios. What is built of old kinds only.
class MachinesTest : public QObject {
  Q_OBJECT

 private slots:
  /// Timex 61 manual; A. Goodrich, The Modern Clock, chapter XVI: an escape wheel of 30 teeth makes 3,600
  /// beats an hour, the hour hand goes round once for twelve turns of the minute hand, and 78 blows are half
  /// a day.
  void aMantelClock() {
    QCOMPARE(ratioOf({{80, 12}, {72, 8}}), Rational(60));
    QCOMPARE(Rational(60) * Rational(2 * 30), Rational(3600));
    QCOMPARE(ratioOf({{12, 36}, {10, 40}}), Rational(1, 12));
    QCOMPARE(ratioOf({{78, 8}}), Rational(-39, 4));
  }

  /// geartrains.com: a one-hand clock, 45 teeth of the escape wheel are 43,200 s.
  void aOneHandClock() {
    QCOMPARE(ratioOf({{80, 13}, {78, 6}, {72, 6}}), Rational(-960));
    QCOMPARE(Rational(960 * 45), Rational(43'200));
  }

  /// Mean rates: the Moon against the Sun, the Metonic calendar, the Saros dial.
  void theAntikytheraMechanism() {
    const Mechanism mechanism = TrainSketch(10)
                                    .joint(0, 1, "b")
                                    .joint(0, 2, "c")
                                    .joint(0, 3, "d")
                                    .joint(0, 4, "e")  // 14: the Moon
                                    .joint(0, 5, "l")
                                    .joint(0, 6, "m")
                                    .joint(0, 7, "n")  // 17: the Metonic dial
                                    .joint(0, 8, "k")  // the large wheel of 223 teeth
                                    .joint(0, 9, "f")
                                    .joint(0, 10, "g")  // 20: the Saros dial
                                    .mesh(1, 2, 64, 38, MeshKind::external)
                                    .mesh(2, 3, 48, 24, MeshKind::external)
                                    .mesh(3, 4, 127, 32, MeshKind::external)
                                    .mesh(1, 5, 64, 38, MeshKind::external)
                                    .mesh(5, 6, 53, 96, MeshKind::external)
                                    .mesh(6, 7, 15, 53, MeshKind::external)
                                    .mesh(6, 8, 27, 223, MeshKind::external)
                                    .mesh(8, 9, 188, 53, MeshKind::external)
                                    .mesh(9, 10, 30, 54, MeshKind::external)
                                    .inputs({{11, "1"}})
                                    .build();
    QCOMPARE(machineRate(mechanism, 14), Rational(-254, 19));
    QCOMPARE(machineRate(mechanism, 17), Rational(-5, 19));
    QCOMPARE(machineRate(mechanism, 20), Rational(-940, 4237));
  }

  /// "1/205": the page rounds.
  void aGuidedVehicle() { QCOMPARE(ratioOf({{13, 60}, {27, 60}, {10, 40}, {11, 55}}), Rational(39, 8000)); }

  /// Gear ratios G4 to G6 of P. I. Corke, and the couplings of the motors that sit behind joint 4: 1 and 1,
  /// and G6 13/72 of motor 6 with joint 5.
  void theWristOfThePuma() {
    Mechanism wrist = pumaWrist();
    const auto motors = [&](const char* q4, const char* q5, const char* q6) {
      wrist.inputs = {{JointId("14"), *Number::fromText(q4), {}},
                      {JointId("15"), *Number::fromText(q5), {}},
                      {JointId("16"), *Number::fromText(q6), {}}};
      const ByJoint<Rational> rates = machineRates(wrist);
      return std::vector<Rational>{rates[3], rates[4], rates[5]};
    };
    const Rational g4(4182, 55), g5(935, 13), g6(12960, 169);
    const auto first = motors("1", "0", "0");
    QCOMPARE(first, (std::vector<Rational>{-g4, 1, 1}));
    const auto second = motors("0", "1", "0");
    QCOMPARE(second[0], Rational(0));
    QCOMPARE(second[1].abs(), g5);
    QCOMPARE(second[2].abs(), g6 * Rational(13, 72));
    const auto third = motors("0", "0", "1");
    QCOMPARE(third[0], Rational(0));
    QCOMPARE(third[1], Rational(0));
    QCOMPARE(third[2].abs(), g6);
  }

  /// The third Prius: sun 1 with motor 1, engine on carrier 2, ring 3, motor 2 on sun 4, carrier 5 braked;
  /// counter shaft 8 and differential 9.
  void thePriusPowerSplit() {
    Mechanism car = TrainSketch(9)
                        .joint(0, 1, "a")
                        .joint(0, 2, "a")
                        .joint(0, 3, "a")
                        .joint(0, 4, "a")
                        .joint(0, 5, "a")
                        .joint(2, 6, "p")
                        .joint(5, 7, "q")
                        .joint(0, 8, "b")
                        .joint(0, 9, "c")
                        .mesh(1, 6, 30, 23, MeshKind::external)
                        .mesh(6, 3, 23, 78, MeshKind::internal)
                        .mesh(4, 7, 22, 18, MeshKind::external)
                        .mesh(7, 3, 18, 58, MeshKind::internal)
                        .mesh(3, 8, 54, 55, MeshKind::external)
                        .mesh(8, 9, 24, 77, MeshKind::external)
                        .build();
    test::addBrake(car, "B", 5);
    test::addBrake(car, "E", 2);
    test::addBrake(car, "G", 1);
    test::addState(car, "electric", {"B", "E"}, 4, 3);
    test::addState(car, "generator", {"B", "E"}, 1, 3);
    test::addState(car, "motor 1 held", {"B", "G"}, 3, 2);
    test::addState(car, "final drive", {"B", "E"}, 3, 9);
    test::addState(car, "both", {"B"}, 2, 9);
    const SnapshotPtr snapshot = snapshotOf(car);
    QVERIFY(snapshot->states);
    const std::vector<Rational> ratios{Rational(-29, 11), Rational(-13, 5), Rational(18, 13),
                                       Rational(4235, 1296)};
    for (std::size_t i = 0; i < ratios.size(); ++i) QCOMPARE(*(*snapshot->states)[i].ratio, ratios[i]);
    QCOMPARE((*snapshot->states)[4].dof, 2);
  }
};

QTEST_GUILESS_MAIN(MachinesTest)
#include "test_machines.moc"
