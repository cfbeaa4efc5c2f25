#include <QTest>

#include "core/design/synthesis/drive_sets.h"
#include "core/design/synthesis/planetary_set.h"
#include "core/design/synthesis/reverted_train.h"
#include "tests/core/support/snapshot_of.h"

using namespace geargraph;

namespace {

/// Speed of the output for one turn of the input, of a set that is in order and that both methods agree on.
Rational driven(const Expected<Mechanism>& set) {
  if (!set) throw std::runtime_error(set.error().front().message);
  const SnapshotPtr snapshot = test::snapshotOf(*set);
  if (hasErrors(snapshot->diagnostics)) throw std::runtime_error(snapshot->diagnostics.front().message);
  if (!snapshot->solved) throw std::runtime_error("not solved");
  if (!snapshot->solved->agreement || !snapshot->solved->agreement->equal)
    throw std::runtime_error("the methods disagree");
  const auto ratio = ratioOfSet(*set);
  if (!ratio) throw std::runtime_error("no ratio");
  return ratio->speed.rational();
}

}  // namespace

/// Drives have the ratios of their makers, with the sign, before they are inserted.
class DriveSetsTest : public QObject {
  Q_OBJECT

 private slots:
  void drivesHaveTheirRatios() {
    QCOMPARE(driven(faceDrive(18, 24)).abs(), Rational(3, 4));
    QCOMPARE(driven(hypoidAxle(10, 41)).abs(), Rational(10, 41));
    const Rational worm = driven(wormStage({2, 31}));
    QCOMPARE(worm.abs(), Rational(2, 31));
    QCOMPARE(driven(wormStage({2, 31, Hand::left})), -worm);
    QCOMPARE(driven(beltStage({20, 50, Number(5), false})), Rational(2, 5));
    QCOMPARE(driven(beltStage({20, 50, Number(5), true})), Rational(-2, 5));
    QCOMPARE(driven(strainWave(200, 202)), Rational(-1, 100));
    QCOMPARE(driven(strainWave(68, 70)), Rational(-1, 34));
    QCOMPARE(driven(cycloidalDrive(16)), Rational(-1, 15));
    QCOMPARE(driven(rvReducer(12, 36, 40)), Rational(1, 121));
    QCOMPARE(driven(rvReducer(16, 32, 40)), Rational(1, 81));
  }

  void travelsHaveTheirUnitAndSign() {
    // 125 mm a turn at module 2 are 20 teeth: 40 pi.
    const auto rack = ratioOfSet(*rackDrive({Number(125), Number(2)}));
    QVERIFY(rack && rack->slides);
    QCOMPARE(rack->speed.abs().toString(), std::string("20"));
    QCOMPARE(rack->ofTurn().abs().toString(), std::string("40*pi"));
    QCOMPARE(rackDrive({Number(125), Number(2)})->gearMeshes.front().tailTeeth, 20);
    // Right-hand: as the screw turns about +z, its nut goes back.
    const auto right = ratioOfSet(*screwDrive({Number(5)}));
    QVERIFY(right && right->slides);
    QCOMPARE(right->speed.toString(), std::string("-5/2/pi"));
    QCOMPARE(right->ofTurn().toString(), std::string("-5"));
    QCOMPARE(ratioOfSet(*screwDrive({Number(5), Hand::left}))->ofTurn().toString(), std::string("5"));
    for (const auto& set : {rackDrive({}), screwDrive({})}) {
      const SnapshotPtr snapshot = test::snapshotOf(*set);
      QVERIFY(!hasErrors(snapshot->diagnostics));
      QVERIFY(snapshot->solved && snapshot->solved->agreement && snapshot->solved->agreement->equal);
    }
  }

  void othersToo() {
    QCOMPARE(ratioOfSet(revertedTrain({20, 40, 20, 40}))->speed.rational(), Rational(1, 4));
    QCOMPARE(int{ratioOfSet(revertedTrain({20, 40, 20, 40}))->input}, 1);
    QVERIFY(!ratioOfSet(planetarySet({20, 20}, 1)));  // two inputs
  }

  void impossibleNumbersAreRejected() {
    QCOMPARE(faceDrive(20, 20).error().front().detail, Detail::teethAgainstRadii);
    QCOMPARE(hypoidAxle(41, 10).error().front().detail, Detail::teethAgainstRadii);
    QCOMPARE(wormStage({9, 40}).error().front().detail, Detail::wormTeeth);
    QCOMPARE(wormStage({5, 5}).error().front().detail, Detail::wormTeeth);
    QCOMPARE(beltStage({20, 40, Number(0)}).error().front().detail, Detail::beltGeometry);
    QVERIFY(!strainWave(202, 200));
    QVERIFY(!cycloidalDrive(3));
    QVERIFY(!rvReducer(12, 36, 2));
    QCOMPARE(rackDrive({Number(10), Number(2)}).error().front().detail, Detail::teethAgainstRadii);
    QCOMPARE(rackDrive({Number(125), Number(0)}).error().front().code, Code::schema);
    QCOMPARE(screwDrive({Number(-5)}).error().front().code, Code::schema);
  }
};

QTEST_GUILESS_MAIN(DriveSetsTest)
#include "test_drive_sets.moc"
