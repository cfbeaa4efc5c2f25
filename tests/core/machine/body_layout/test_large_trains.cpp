#include <QTest>
#include <algorithm>
#include <cmath>
#include <set>

#include "core/machine/body_layout/arrangement.h"
#include "core/machine/body_layout/complete_train.h"
#include "core/machine/train/wheel_envelopes.h"
#include "tests/core/machine/solids/topology.h"
#include "tests/core/support/deep_train.h"
#include "tests/core/support/train_sketch.h"

using namespace geargraph;

namespace {

TrainWheels stackedWheels(const Mechanism& mechanism, const Placement& placement) {
  TrainWheels wheels = wheelsOf(mechanism, placement);
  shapeWheels(mechanism, wheels);
  stackWheels(wheels, placement);
  return wheels;
}

/// Trains of which wheels collide in every way: parallel ones and bevels beside each other, on carriers that
/// go round one axis, and in rings.
std::vector<Mechanism> crowdedTrains() {
  std::vector<Mechanism> trains;
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    trains.push_back(test::deepTrain(seed, 120));
    trains.push_back(test::randomTrain(seed, 60, 60));
  }
  return trains;
}

}  // namespace

/// Trains of hundreds and thousands of links.
class LargeTrainsTest : public QObject {
  Q_OBJECT

 private slots:
  void wheelsThatCollideAreAmongTheNearPairs() {
    int collisions = 0;
    for (const Mechanism& mechanism : crowdedTrains()) {
      const Placement placement = placementOf(mechanism);
      const TrainWheels wheels = stackedWheels(mechanism, placement);
      const WheelEnvelopes envelopes(wheels, placement);
      const auto near = envelopes.nearPairs();
      QVERIFY(std::is_sorted(near.begin(), near.end()));
      QVERIFY(std::adjacent_find(near.begin(), near.end()) == near.end());
      const int count = static_cast<int>(wheels.wheels.size());
      for (int a = 0; a < count; ++a) {
        for (int b = a + 1; b < count; ++b) {
          if (!envelopes.collide(a, b)) continue;
          ++collisions;
          QVERIFY(std::binary_search(near.begin(), near.end(), std::pair(a, b)));
          QVERIFY(envelopes.mayIntersect(a, b));
          QVERIFY(envelopes.mayIntersect(b, a));
        }
      }
    }
    QVERIFY2(collisions > 100, qPrintable(QString::number(collisions)));
  }

  void aMovedWheelIntersectsOnlyWhatItMayIntersect() {
    int collisions = 0;
    for (const Mechanism& mechanism : crowdedTrains()) {
      const Placement placement = placementOf(mechanism);
      const TrainWheels wheels = stackedWheels(mechanism, placement);
      const int count = static_cast<int>(wheels.wheels.size());
      for (int a = 0; a < count; a += 7) {
        const TrainWheel& wheel = wheels.wheels[static_cast<std::size_t>(a)];
        if (wheel.spec.kind == GearKind::bevel) continue;
        for (const double steps : {-9.0, 2.0, 5.0}) {
          WheelEnvelopes envelopes(wheels, placement);
          envelopes.move(a, steps * wheel.spec.faceWidth * wheel.axis);
          for (int b = 0; b < count; ++b) {
            if (a == b || !envelopes.collide(a, b)) continue;
            ++collisions;
            QVERIFY(envelopes.mayIntersect(a, b));
          }
        }
      }
    }
    QVERIFY2(collisions > 100, qPrintable(QString::number(collisions)));
  }

  void aNewFaceWidthIsThatOfNewEnvelopes() {
    const Mechanism mechanism = test::deepTrain(1, 120);
    const Placement placement = placementOf(mechanism);
    TrainWheels wheels = stackedWheels(mechanism, placement);
    WheelEnvelopes kept(wheels, placement);
    const int count = static_cast<int>(wheels.wheels.size());
    for (int w = 0; w < count; w += 3) {
      wheels.wheels[static_cast<std::size_t>(w)].spec.faceWidth *= 0.5;
      kept.update(w);
    }
    const WheelEnvelopes renewed(wheels, placement);
    QVERIFY(kept.nearPairs() == renewed.nearPairs());
    for (const auto& [a, b] : renewed.nearPairs()) QCOMPARE(kept.collide(a, b), renewed.collide(a, b));
  }

  /// The work of looking for collisions grows with the train, not with its square.
  void nearPairsGrowWithTheTrain() {
    const auto pairsOf = [](int links) {
      const Mechanism mechanism = test::deepTrain(1, links);
      const Placement placement = placementOf(mechanism);
      TrainWheels wheels = wheelsOf(mechanism, placement);
      shapeWheels(mechanism, wheels);
      return WheelEnvelopes(wheels, placement).nearPairs().size();
    };
    const std::size_t few = pairsOf(500), many = pairsOf(2000);
    QVERIFY2(many < 8 * few, qPrintable(QStringLiteral("%1 and %2").arg(few).arg(many)));
  }

  void aThousandLinksHaveWheelsAndStraightBodies() {
    const Mechanism mechanism = test::deepTrain(1, 1000);
    const GearTrain train = trainOf(mechanism, placementOf(mechanism));
    QVERIFY(train.gears.size() > kMaxRoutedGears);
    QVERIFY(train.hasSimpleBodies);
    QCOMPARE(train.meshes.size(), mechanism.gearMeshes.size());
    for (const TrainGear& gear : train.gears) QVERIFY(gear.spec.body == GearBody::plain);
    std::set<int> links;
    for (const LinkBody& body : train.bodies) {
      links.insert(body.link);
      const Solid& solid = *body.coarse->solid();
      QVERIFY(!solid.triangles.empty());
      for (const Float3& p : solid.positions)
        QVERIFY(std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]));
      if (body.link % 50 == 0) QVERIFY(test::Weld(solid).examine().balanced);
    }
    QVERIFY2(links.size() > 900, qPrintable(QString::number(links.size())));
  }

  void aTrainAtTheBoundIsRouted() {
    const Mechanism mechanism = test::deepTrain(1, 60);
    const GearTrain train = trainOf(mechanism, placementOf(mechanism));
    QVERIFY(train.gears.size() <= kMaxRoutedGears);
    QVERIFY(!train.hasSimpleBodies);
  }
};

QTEST_APPLESS_MAIN(LargeTrainsTest)
#include "test_large_trains.moc"
