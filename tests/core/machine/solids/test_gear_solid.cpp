#include <QTest>
#include <array>
#include <cmath>
#include <thread>

#include "core/machine/solids/gear_solid.h"
#include "core/machine/solids/toothless_gear.h"
#include "core/machine/teeth/half_tooth.h"
#include "tests/core/machine/solids/topology.h"

using namespace geargraph;

namespace {

GearSpec gear(int kind, int teeth, double cone, double bore) {
  GearSpec spec = standardGear(static_cast<GearKind>(kind), teeth, 2, 9);
  spec.coneAngle = cone * std::numbers::pi / 180;
  if (kind == 2) spec.faceWidth = coneDistance(spec) / 3;
  spec.bore = bore;
  return spec;
}

/// Area of the section of a spur gear or a ring from the closed forms of involute and tip arc; of fillet and
/// root, which have none, from a very fine polygon. Lengths in modules.
double sectionArea(const GearSpec& spec) {
  const bool ring = spec.kind == GearKind::internal;
  const HalfTooth tooth = ring ? ringTooth(spec, 1e-8) : externalTooth(spec, 1e-8);
  const double rb = spec.teeth / 2.0 * std::cos(spec.pressureAngle);
  const auto roll = [&](double rad) { return std::sqrt(rad * rad / (rb * rb) - 1); };
  double half = rb * rb * std::abs(std::pow(roll(tooth.tipRad), 3) - std::pow(roll(tooth.formRad), 3)) / 6;
  half += tooth.tipRad * tooth.tipRad * tooth.tipHalfAngle / 2;
  const auto isBelowFlank = [&](double rad) { return ring ? rad > tooth.formRad : rad < tooth.formRad; };
  for (std::size_t i = 0; i + 1 < tooth.points.size() && isBelowFlank(tooth.points[i].rad); ++i) {
    const ProfilePoint& a = tooth.points[i];
    const ProfilePoint& b = tooth.points[i + 1];
    half += 0.5 * a.rad * b.rad * std::sin(a.gam - b.gam);
  }
  const double round = std::numbers::pi * std::pow((ring ? spec.rim : spec.bore) / spec.module, 2) / 4;
  return ring ? round - 2 * spec.teeth * half : 2 * spec.teeth * half - round;
}

/// Volume of all teeth of a bevel between two colatitudes on the flank, from the closed form of the spherical
/// involute: walls are cones through the apex, ends are back cone and front cone.
double toothVolume(const GearSpec& spec, double from, double to) {
  constexpr int kSteps = 20'000;
  const double far = coneDistance(spec), near = far - spec.faceWidth;
  double sum = 0;
  for (int k = 0; k < kSteps; ++k) {
    const double c = from + (k + 0.5) * (to - from) / kSteps;
    sum += sphericalInvoluteHalfAngle(spec, c) * std::sin(c) / std::pow(std::cos(c - spec.coneAngle), 3);
  }
  return 2 * spec.teeth * sum * (to - from) / kSteps * (std::pow(far, 3) - std::pow(near, 3)) / 3;
}

}  // namespace

class GearSolidTest : public QObject {
  Q_OBJECT
 private slots:
  void solidsAreClosedManifoldAndOutward_data() {
    QTest::addColumn<int>("kind");
    QTest::addColumn<int>("teeth");
    QTest::addColumn<double>("cone");
    QTest::addColumn<double>("bore");
    QTest::addColumn<int>("genus");
    QTest::newRow("spur 40") << 0 << 40 << 0.0 << 20.0 << 1;
    QTest::newRow("spur 40 without bore") << 0 << 40 << 0.0 << 0.0 << 0;
    QTest::newRow("pinion 8") << 0 << 8 << 0.0 << 3.0 << 1;
    QTest::newRow("pinion 5") << 0 << 5 << 0.0 << 0.0 << 0;
    QTest::newRow("pinion 3") << 0 << 3 << 0.0 << 0.0 << 0;
    QTest::newRow("ring 4") << 1 << 4 << 0.0 << 0.0 << 1;
    QTest::newRow("ring 7") << 1 << 7 << 0.0 << 0.0 << 1;
    QTest::newRow("ring 11") << 1 << 11 << 0.0 << 0.0 << 1;
    QTest::newRow("bevel 6 at 14") << 2 << 6 << 14.0 << 0.0 << 0;
    QTest::newRow("wheel 317") << 0 << 317 << 0.0 << 30.0 << 1;
    QTest::newRow("ring 60") << 1 << 60 << 0.0 << 0.0 << 1;
    QTest::newRow("ring 13") << 1 << 13 << 0.0 << 0.0 << 1;
    QTest::newRow("ring 20") << 1 << 20 << 0.0 << 0.0 << 1;
    QTest::newRow("ring 240") << 1 << 240 << 0.0 << 0.0 << 1;
    QTest::newRow("bevel 20 at 27") << 2 << 20 << 26.565 << 8.0 << 1;
    QTest::newRow("bevel 40 at 63") << 2 << 40 << 63.435 << 20.0 << 1;
    QTest::newRow("mitre 16 without bore") << 2 << 16 << 45.0 << 0.0 << 0;
    QTest::newRow("steep pinion 8") << 2 << 8 << 11.3 << 2.0 << 1;
    QTest::newRow("crown 40") << 2 << 40 << 90.0 << 10.0 << 1;
    QTest::newRow("internal cone 40") << 2 << 40 << 110.0 << 0.0 << 1;
  }
  void solidsAreClosedManifoldAndOutward() {
    QFETCH(int, kind);
    QFETCH(int, teeth);
    QFETCH(double, cone);
    QFETCH(double, bore);
    QFETCH(int, genus);
    for (const double tolerance : {kExportTolerance, kScreenTolerance, kFarTolerance}) {
      const Expected<Solid> solid = gearSolid(gear(kind, teeth, cone, bore), tolerance);
      QVERIFY(solid.has_value());
      const test::Topology topology = test::topologyOf(*solid);
      QVERIFY(topology.closed);
      QVERIFY(topology.manifold);
      QCOMPARE(topology.degenerate, 0);
      QCOMPARE(topology.pieces, 1);
      QCOMPARE(topology.genus, genus);
      QVERIFY(signedVolume(*solid) > 0);
      QCOMPARE(solid->positions.size(), solid->normals.size());
      if (tolerance == kExportTolerance) {
        const double worst = test::worstNormalDegrees(*solid, 1e-3);
        QVERIFY2(worst < 20, qPrintable(QString::number(worst)));
      }
    }
  }

  /// Corners that two rules reach must come out as one position, for every tooth count.
  void everyToothCountGivesAManifold() {
    for (const GearKind kind : {GearKind::external, GearKind::internal, GearKind::bevel}) {
      for (int teeth = kind == GearKind::internal ? 4
                       : kind == GearKind::bevel  ? 6
                                                  : 3;
           teeth <= 45; ++teeth) {
        GearSpec spec = gear(static_cast<int>(kind), teeth, 40, 0);
        spec.backlashAllowance = 0.02;
        const test::Topology topology = test::topologyOf(*gearSolid(spec, kScreenTolerance));
        QVERIFY2(topology.closed && topology.manifold && topology.degenerate == 0,
                 qPrintable(QString("kind %1, %2 teeth").arg(static_cast<int>(kind)).arg(teeth)));
      }
    }
  }

  /// Hub, web and spokes: the genus is that of the bore and the windows.
  void dressedWheelsAreClosedToo() {
    int windowed = 0;
    for (const int teeth : {18, 30, 45, 60, 100, 250}) {
      GearSpec spec = gear(0, teeth, 0, 8);
      spec.body = GearBody::dressed;
      const Expected<Solid> solid = gearSolid(spec, kScreenTolerance);
      const test::Topology topology = test::topologyOf(*solid);
      QVERIFY(topology.closed);
      QVERIFY(topology.manifold);
      QCOMPARE(topology.degenerate, 0);
      QCOMPARE(topology.pieces, 1);
      windowed += topology.genus > 1 ? 1 : 0;
      QVERIFY(topology.genus == 1 || (topology.genus >= 5 && topology.genus <= 9));
      const double worst = test::worstNormalDegrees(*solid, 1e-3);
      QVERIFY2(worst < 25, qPrintable(QString("%1 teeth: %2").arg(teeth).arg(worst)));
      GearSpec plain = spec;
      plain.body = GearBody::plain;
      QVERIFY(signedVolume(*solid) <= signedVolume(*gearSolid(plain, kScreenTolerance)));
    }
    QVERIFY(windowed >= 3);
  }

  /// Without teeth a gear is closed, about as large as with them, and its cost grows little with their
  /// number.
  void toothlessGearsAreClosedAndFillThePitchCylinder() {
    for (const int kind : {0, 1, 2}) {
      for (const int teeth : {60, 6'000, 100'000}) {
        GearSpec spec = gear(kind, teeth, 45, 8);
        if (kind == 0) spec.body = GearBody::dressed;
        const Solid solid = toothlessGear(spec, kScreenTolerance);
        const test::Topology topology = test::topologyOf(solid);
        QVERIFY(topology.closed && topology.manifold && topology.degenerate == 0);
        QVERIFY(solid.triangles.size() < 200'000);
        if (teeth > 60) continue;
        spec.body = GearBody::plain;
        const double volume = signedVolume(toothlessGear(spec, kScreenTolerance));
        const double toothed = signedVolume(*gearSolid(spec, kScreenTolerance));
        QVERIFY2(std::abs(volume / toothed - 1) < 0.25, qPrintable(QString::number(volume / toothed)));
      }
    }
  }

  void volumeIsTheSectionTimesTheFaceWidth_data() {
    QTest::addColumn<int>("kind");
    QTest::addColumn<int>("teeth");
    QTest::addColumn<double>("shift");
    QTest::addColumn<double>("round");
    QTest::newRow("40") << 0 << 40 << 0.0 << 20.0;
    QTest::newRow("8, undercut") << 0 << 8 << 0.0 << 3.0;
    QTest::newRow("12, shifted") << 0 << 12 << 0.4 << 6.0;
    QTest::newRow("ring 60") << 1 << 60 << 0.0 << 140.0;
    QTest::newRow("ring 30, shifted") << 1 << 30 << 0.3 << 78.0;
  }
  void volumeIsTheSectionTimesTheFaceWidth() {
    QFETCH(int, kind);
    QFETCH(int, teeth);
    QFETCH(double, shift);
    QFETCH(double, round);
    GearSpec spec = gear(kind, teeth, 0, kind == 0 ? round : 0);
    if (kind == 1) spec.rim = round;
    spec.profileShift = shift;
    const double exact = sectionArea(spec) * spec.module * spec.module * spec.faceWidth;
    const Expected<Solid> solid = gearSolid(spec, 0.002);
    QVERIFY(std::abs(signedVolume(*solid) / exact - 1) < 0.0012);
    const Expected<Solid> fine = gearSolid(spec, 1e-4);
    QVERIFY(std::abs(signedVolume(*fine) / exact - 1) < 1e-4);
  }

  /// Of two bevels that differ in the height of their teeth only, what the one has more.
  void volumeOfBevelTeethIsThatOfTheSphericalInvolute() {
    for (const double cone : {26.565, 45.0, 63.435, 100.0}) {
      const GearSpec tall = gear(2, 32, cone, 8);
      GearSpec low = tall;
      low.addendum = 0.4;
      const double exact = toothVolume(tall, bevelTooth(low, 1e-6).tipRad, bevelTooth(tall, 1e-6).tipRad);
      const double found = signedVolume(*gearSolid(tall, 2e-5)) - signedVolume(*gearSolid(low, 2e-5));
      QVERIFY2(std::abs(found / exact - 1) < 2e-3,
               qPrintable(QString("%1: %2").arg(cone).arg(found / exact)));
    }
  }

  /// Walls of bevels are cones through the apex: both ends of an edge of a tooth lie on one ray, at the
  /// distances of back cone and front cone.
  void bevelEdgesMeetInTheApex() {
    const GearSpec spec = gear(2, 20, 35, 0);
    const HalfTooth tooth = bevelTooth(spec, 0.002);
    const Expected<Solid> solid = gearSolid(spec, 0.002);
    const std::size_t walls = 20 * (2 * tooth.points.size() - 2);
    for (std::size_t i = 0; i < walls; ++i) {
      const Eigen::Vector3d a = Eigen::Map<const Eigen::Vector3f>(solid->positions[i].data()).cast<double>();
      const Eigen::Vector3d b =
          Eigen::Map<const Eigen::Vector3f>(solid->positions[walls + i].data()).cast<double>();
      QVERIFY(a.normalized().cross(b.normalized()).norm() < 1e-6);
      const double colatitude = std::atan2(std::hypot(b.x(), b.y()), b.z());
      QVERIFY(std::abs(b.norm() * std::cos(colatitude - spec.coneAngle) - coneDistance(spec)) < 1e-4);
    }
  }

  void toothZeroIsCentredOnTheXAxis() {
    const Expected<Solid> solid = gearSolid(gear(0, 40, 0, 0), 0.002);
    float farthest = 0;
    for (const Float3& p : solid->positions) farthest = std::max(farthest, p[0]);
    QVERIFY(std::abs(farthest - 42) < 1e-5F);
    bool mirrored = true;
    for (std::size_t i = 0; i < 40; ++i) mirrored = mirrored && solid->positions[i][2] == -4.5F;
    QVERIFY(mirrored);
  }

  void equalSpecsGiveEqualSolids() {
    QVERIFY(*gearSolid(gear(2, 17, 40, 5), 0.002) == *gearSolid(gear(2, 17, 40, 5), 0.002));
  }

  void cacheMakesASolidOnce() {
    GearCache cache(2);
    const auto first = cache.solid(gear(0, 20, 0, 5), 0.01);
    QVERIFY(*first == *cache.solid(gear(0, 20, 0, 5), 0.01));
    QVERIFY(*first != *cache.solid(gear(0, 20, 0, 5), 0.002));
    static_cast<void>(cache.solid(gear(0, 20, 0, 5), 0.01));
    static_cast<void>(cache.solid(gear(0, 21, 0, 5), 0.01));  // drops the one of 0.002, the oldest
    QCOMPARE(cache.size(), std::size_t(2));
    QVERIFY(*first == *cache.solid(gear(0, 20, 0, 5), 0.01));
  }

  void aDeferredSolidIsMadeWhenSomebodyAsks() {
    GearCache cache;
    const auto later = cache.deferred(gear(0, 20, 0, 5), 0.01).value();
    QVERIFY(later->solidIfReady() == nullptr);
    const auto solid = later->solid();
    QCOMPARE(later->solidIfReady(), solid.get());
    QVERIFY(*solid == *gearSolid(gear(0, 20, 0, 5), 0.01));
    QCOMPARE(cache.solid(gear(0, 20, 0, 5), 0.01).value(), solid);  // not made again
    QCOMPARE(cache.deferred(gear(0, 20, 0, 5), 0.01).value(), later);
    QVERIFY(!cache.deferred(gear(0, 20, 0, 36), 0.01).has_value());
  }

  void threadsThatAskTogetherGetTheSameSolid() {
    GearCache cache;
    const auto later = cache.deferred(gear(0, 20, 0, 5), 0.01).value();
    std::array<std::shared_ptr<const Solid>, 4> got;
    {
      std::vector<std::jthread> threads;
      for (auto& each : got) threads.emplace_back([&each, &later] { each = later->solid(); });
    }
    for (const auto& each : got) QCOMPARE(each.get(), later->solidIfReady());
  }

  void impossibleGearsAreRejectedWithASentence_data() {
    QTest::addColumn<int>("kind");
    QTest::addColumn<int>("teeth");
    QTest::addColumn<double>("cone");
    QTest::addColumn<double>("bore");
    QTest::newRow("two teeth") << 0 << 2 << 0.0 << 0.0;
    QTest::newRow("bore past the roots") << 0 << 20 << 0.0 << 36.0;
    QTest::newRow("ring of three") << 1 << 3 << 0.0 << 0.0;
    QTest::newRow("no cone") << 2 << 20 << 0.0 << 0.0;
  }
  void impossibleGearsAreRejectedWithASentence() {
    QFETCH(int, kind);
    QFETCH(int, teeth);
    QFETCH(double, cone);
    QFETCH(double, bore);
    GearSpec spec = gear(0, teeth, cone, bore);
    spec.kind = static_cast<GearKind>(kind);
    const Expected<Solid> solid = gearSolid(spec, 0.002);
    QVERIFY(!solid.has_value());
    QCOMPARE(solid.error().front().code, Code::teethGeometry);
    QVERIFY(solid.error().front().message.size() > 20);
  }

  void nonsenseNumbersAreRejected() {
    GearSpec spec = gear(0, 20, 0, 0);
    spec.module = std::nan("");
    QVERIFY(!gearSolid(spec, 0.002).has_value());
    spec = gear(0, 20, 0, 0);
    spec.pressureAngle = 1.2;
    QVERIFY(!gearSolid(spec, 0.002).has_value());
  }
};

QTEST_APPLESS_MAIN(GearSolidTest)
#include "test_gear_solid.moc"
