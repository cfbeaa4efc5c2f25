#include <QTest>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/machine/body_layout/swept_envelope.h"
#include "tests/core/machine/body_layout/planned_train.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/train_sketch.h"

using namespace geargraph;
using Eigen::Vector3d;

namespace {

struct FramedTrain : test::PlannedTrain {
  explicit FramedTrain(const Mechanism& mechanism)
      : PlannedTrain(mechanism), envelopes(sweptEnvelopes(plan, train, placement)) {}

  std::vector<SweptEnvelope> envelopes;
};

Mechanism randomTrain(std::uint64_t seed) {
  return test::randomTrain(seed, 3 + static_cast<int>(seed % 6), 2 + static_cast<int>(seed % 5));
}

/// The envelope of a link's gear.
const SweptEnvelope& gearOf(const FramedTrain& planned, int link) {
  return *std::find_if(planned.envelopes.begin(), planned.envelopes.end(),
                       [&](const SweptEnvelope& e) { return e.link == link && e.kind == HullKind::gear; });
}

}  // namespace

/// What moving parts sweep, and the frame that stays clear of it.
class GroundFrameTest : public QObject {
  Q_OBJECT
 private slots:
  /// Sun 24, planet 18, ring 60 at module 2: the planet goes round at 42, its tips at 20.
  void aPlanetSweepsARing() {
    const FramedTrain planned(test::example("planetary-ring-held"));
    const SweptEnvelope& sun = gearOf(planned, 1);
    const SweptEnvelope& planet = gearOf(planned, 3);
    const double distance =
        (planned.train.gears[0].pose.translation() - planned.train.gears[1].pose.translation()).norm();
    QVERIFY(sun.isOnAxis && !planet.isOnAxis);
    QCOMPARE(sun.inner, 0.0);
    QVERIFY(distance > 1);
    QVERIFY(std::abs((planet.inner + planet.outer) / 2 - distance) < 1e-9 * distance);
    QVERIFY(planet.outer - planet.inner > 2 * 0.9 * (distance - sun.outer));
    const auto isNear = [&](const Vector3d& place, double margin) {
      return planet.isNear(place, place, margin);
    };
    const Vector3d out = distance * Vector3d::UnitX(), up = (planet.high - planet.low) * Vector3d::UnitZ();
    QVERIFY(isNear(planet.point + out, 0));
    QVERIFY(!isNear(planet.point, 0));
    QVERIFY(isNear(planet.point, planet.inner + 1e-9));
    QVERIFY(!isNear(planet.point + out + up, 0));
    QVERIFY(planet.isNear(planet.point - 5 * out, planet.point + 5 * out, 0));             // through it
    QVERIFY(!planet.isNear(planet.point - 5 * up, planet.point + 5 * up, 0));              // through its hole
    QVERIFY(!planet.isNear(planet.point - 5 * out + up, planet.point + 5 * out + up, 0));  // over it
  }

  /// Turned by any angles of its joints, a part stays within its envelope: the discs of all hulls of random
  /// trains, turned about their own axes down to the ground.
  void partsStayInTheirEnvelopes() {
    int places = 0;
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
      const FramedTrain planned(randomTrain(seed));
      const AxisGroups& classes = *planned.placement.classes;
      const auto hulls = bodyHulls(planned.plan, planned.train, {0, true});
      std::size_t e = 0;
      for (const BodyHull& hull : hulls) {
        if (hull.link == 0) continue;
        const SweptEnvelope& envelope = planned.envelopes.at(e++);
        QCOMPARE(envelope.link, hull.link);
        for (const Disc& disc : hull.discs) {
          Vector3d p(disc.centre[0], disc.centre[1], disc.centre[2]);
          double angle = 0.7 * static_cast<double>(seed);
          for (int link = hull.link; link != 0;) {
            const int c = classes.classOfLink(link);
            const AxisLayout& axis = planned.plan.axes[static_cast<std::size_t>(c)];
            p = axis.point + Eigen::AngleAxisd(angle, axis.direction) * (p - axis.point);
            link = classes.classes[static_cast<std::size_t>(c)].rootLink;
            angle += 1.3;
          }
          QVERIFY(envelope.isNear(p, p, 1e-6 * (1 + envelope.outer)));
          ++places;
        }
      }
      QCOMPARE(e, planned.envelopes.size());
    }
    QVERIFY(places > 1000);
  }

  void theFrameStaysClearOfWhatMoves() {
    int bars = 0;
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
      const FramedTrain planned(randomTrain(seed));
      const FramePlan& frame = planned.plan.frame;
      for (const SweptEnvelope& e : planned.envelopes) {
        if (!frame.feet.empty()) QVERIFY(e.lowestAlong(Vector3d::UnitZ()) > frame.top);
        for (const FrameBar& bar : frame.bars) {
          ++bars;
          const bool isInOwnBearing = e.isOnAxis && e.kind == HullKind::shaft;
          QVERIFY(isInOwnBearing || !e.isNear(bar.from, bar.to, bar.radius));
        }
      }
    }
    QVERIFY(bars > 1000);
  }

  /// Where envelopes leave a way the ground is one body: in all examples, and in most random trains, whose
  /// deep carriers sweep round many bearings.
  void bearingsRarelyStayOnPedestalsOfTheirOwn() {
    for (const std::string& name : test::exampleNames()) {
      const Mechanism mechanism = test::example(name);
      if (placementOf(mechanism).tree)
        QVERIFY2(FramedTrain(mechanism).plan.frame.onPedestals.empty(), name.c_str());
    }
    int separate = 0;
    for (std::uint64_t seed = 1; seed <= 200; ++seed)
      separate += FramedTrain(randomTrain(seed)).plan.frame.onPedestals.empty() ? 0 : 1;
    QVERIFY2(separate <= 60, qPrintable(QString::number(separate)));
  }

  /// Two shafts on the ground with nothing else: joined without a base.
  void aSpurPairNeedsNoBase() {
    const FramePlan frame = FramedTrain(test::example("spur-pair")).plan.frame;
    QVERIFY(frame.bars.empty() && frame.feet.empty() && frame.housings.empty() && frame.onPedestals.empty());
  }

  /// The bearings of a differential stand on two columns.
  void aDifferentialStandsOnItsBase() {
    const FramePlan frame = FramedTrain(test::example("bevel-differential")).plan.frame;
    QCOMPARE(frame.bars.size(), std::size_t{2});
    QCOMPARE(frame.feet.size(), std::size_t{2});
    QCOMPARE(frame.housings.size(), std::size_t{1});
    for (const FrameBar& bar : frame.bars) {
      const Vector3d way = (bar.to - bar.from).normalized();
      QVERIFY((way + Vector3d::UnitZ()).norm() < 1e-9);
    }
  }

  /// The carrier's bearing is carried by a bridge over the ring.
  void aRingCarriesTheBridgeOverIt() {
    const FramePlan frame = FramedTrain(test::example("planetary-ring-held")).plan.frame;
    QCOMPARE(frame.bars.size(), std::size_t{2});
    QVERIFY(frame.feet.empty());
  }
};

QTEST_APPLESS_MAIN(GroundFrameTest)
#include "test_ground_frame.moc"
