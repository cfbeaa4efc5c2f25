#include <QTest>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include "core/machine/solids/gear_body.h"
#include "core/machine/solids/gear_solid.h"
#include "core/machine/solids/spec_diagnostics.h"
#include "core/machine/teeth/phase.h"
#include "core/machine/teeth/wheel_kind.h"
#include "core/machine/teeth/worm.h"
#include "tests/core/machine/solids/topology.h"
#include "tests/quality/section_checker.h"

using namespace geargraph;
using Eigen::Isometry3d;
using Eigen::Vector3d;
using std::numbers::pi;

namespace {

constexpr double kWormDegree = pi / 180;
/// Backlash of a pair, in modules: half of it for each wheel.
constexpr double kWormPlay = 0.04;

struct WormPair {
  GearSpec worm;
  GearSpec wheel;
};

WormPair wormPair(int starts, int teeth, double module, double diameter, int hand, double shift = 0) {
  WormPair pair{wormSpec(starts, module, diameter / 2, hand, 20 * kWormDegree, 1),
                wormWheelSpec(teeth, starts, module, diameter / 2, hand, 20 * kWormDegree, 1)};
  pair.worm.backlashAllowance = pair.wheel.backlashAllowance = kWormPlay / 2;
  pair.wheel.profileShift = shift;
  pair.wheel.faceWidth = usualWheelFace(pair.wheel);
  pair.worm.faceWidth = usualWormLength(pair.wheel);
  return pair;
}

/// z along `axis`, x (and so tooth 0) along `mark`.
Isometry3d wheelPose(const Vector3d& centre, const Vector3d& axis, const Vector3d& mark) {
  Isometry3d pose = Isometry3d::Identity();
  pose.linear() << mark, axis.cross(mark), axis;
  pose.translation() = centre;
  return pose;
}

PhaseWheel phaseAt(const GearSpec& spec, const Isometry3d& pose) {
  return phaseWheelOf(spec, pose.translation(), pose.linear().col(2), pose.linear().col(0));
}

Isometry3d turnedBy(const Isometry3d& pose, double angle) {
  return pose * Eigen::AngleAxisd(angle, Vector3d::UnitZ());
}

/// What a worm and its wheel turn out to be when both solids are cut square to the wheel's axis. Lengths in
/// axial modules, at the wheel's pitch circle.
struct WormReport {
  double overlap = 0;
  double transmissionError = 0;  ///< peak to peak, the worse of both flanks
  double offCentre = 0;          ///< of the middle of the play
  double leastPlay = 1e300;      ///< both ways together
  double mostPlay = 0;
  double mostInSection = 0;  ///< the largest play of any single section
};

class WormSections {
 public:
  /// The wheel's axis is z; the worm's passes at the distance, along y or, `reversed`, against it.
  WormSections(WormPair pair, bool reversed = false, double tolerance = kExportTolerance)
      : m_pair(std::move(pair)),
        m_worm(gearSolid(m_pair.worm, tolerance).value()),
        m_wheel(gearSolid(m_pair.wheel, tolerance).value()) {
    const Vector3d axis(0, reversed ? -1 : 1, 0);
    m_wormPose = wheelPose({wormDistance(m_pair.wheel), 0, 0}, axis, Vector3d::UnitZ());
    const PhaseWheel worm = phaseAt(m_pair.worm, m_wormPose);
    const PhaseWheel wheel = phaseAt(m_pair.wheel, Isometry3d::Identity());
    const Vector3d point(pitchRadius(m_pair.wheel), 0, 0);
    m_phase = meshPhase(worm, wheel, point);
    m_start = meshingAngle(m_phase, worm, 0, wheel);
    for (const double share : {-0.8, -0.41, 0.0, 0.37, 0.83})
      m_heights.push_back(share * m_pair.wheel.faceWidth / 2 + 0.00137);
    for (const double height : m_heights) m_wheelCuts.push_back(test::Section::flat(m_wheel, height));
  }

  /// Turns the worm by `steps` through a pitch. `wrong` is added to the wheel's angle, in pitches.
  [[nodiscard]] WormReport report(int steps, double wrong = 0) const {
    WormReport report;
    std::array<double, 2> least{1e300, 1e300}, most{-1e300, -1e300};
    const double radius = pitchRadius(m_pair.wheel), module = m_pair.wheel.module;
    for (int step = 0; step < steps; ++step) {
      const double turn = 2 * pi / m_pair.worm.teeth * (step + 0.31) / steps;
      const double angle =
          m_start + m_phase.sign * m_pair.worm.teeth * turn / m_pair.wheel.teeth + wrong * pitchAngle();
      std::array<double, 2> play{1e300, 1e300};
      const Solid worm = moved(m_worm, turnedBy(m_wormPose, turn));
      for (std::size_t i = 0; i < m_heights.size(); ++i) {
        const test::Section cut = test::Section::flat(worm, m_heights[i]);
        report.overlap = std::max(report.overlap, depth(cut, i, angle) / module);
        std::array<double, 2> here{};
        for (const int side : {0, 1}) here[side] = playOf(cut, i, angle, side == 0 ? 1 : -1);
        report.mostInSection = std::max(report.mostInSection, (here[0] + here[1]) * radius / module);
        for (const int side : {0, 1}) play[side] = std::min(play[side], here[side]);
      }
      for (const int side : {0, 1}) {
        least[side] = std::min(least[side], play[side] * radius / module);
        most[side] = std::max(most[side], play[side] * radius / module);
      }
      report.leastPlay = std::min(report.leastPlay, (play[0] + play[1]) * radius / module);
      report.mostPlay = std::max(report.mostPlay, (play[0] + play[1]) * radius / module);
      report.offCentre = std::max(report.offCentre, std::abs(play[0] - play[1]) / 2 * radius / module);
    }
    report.transmissionError = std::max(most[0] - least[0], most[1] - least[1]);
    return report;
  }
  [[nodiscard]] const MeshPhase& phase() const { return m_phase; }

 private:
  [[nodiscard]] double pitchAngle() const { return 2 * pi / m_pair.wheel.teeth; }
  [[nodiscard]] double depth(const test::Section& worm, std::size_t i, double angle) const {
    const Vector3d point(pitchRadius(m_pair.wheel), 0, 0);
    const double reach = m_pair.worm.faceWidth / 2 + 2 * m_pair.wheel.module;
    return test::interpenetration({&worm, Isometry3d::Identity()},
                                  {&m_wheelCuts[i], turnedBy(Isometry3d::Identity(), angle)}, point, reach);
  }
  [[nodiscard]] double playOf(const test::Section& worm, std::size_t i, double angle, int way) const {
    double low = 0, high = 0.15 * pitchAngle();
    for (int step = 0; step < 12; ++step) {
      const double middle = 0.5 * (low + high);
      (depth(worm, i, angle + way * middle) > 1e-6 * m_pair.wheel.module ? high : low) = middle;
    }
    return low;
  }

  WormPair m_pair;
  Solid m_worm, m_wheel;
  Isometry3d m_wormPose;
  MeshPhase m_phase;
  double m_start = 0;
  std::vector<double> m_heights;
  std::vector<test::Section> m_wheelCuts;
};

/// Two helical wheels on crossed axes, cut by the plane through their pitch point that holds the common
/// perpendicular and the tooth normal: both lines of action lie in it. Lengths in normal modules.
class CrossedSection {
 public:
  /// The first wheel's axis is z, the pitch point lies on x.
  CrossedSection(const GearSpec& a, const GearSpec& b)
      : m_a(a), m_b(b), m_solidA(gearSolid(a, kFine).value()), m_solidB(gearSolid(b, kFine).value()) {
    const double crossing = -a.helixAngle - b.helixAngle;
    const Vector3d axis(0, -std::sin(crossing), std::cos(crossing));
    const Vector3d point(pitchRadius(a), 0, 0);
    m_poseB = wheelPose({pitchRadius(a) + pitchRadius(b), 0, 0}, axis, Vector3d::UnitX());
    m_phase = meshPhase(phaseAt(a, Isometry3d::Identity()), phaseAt(b, m_poseB), point);
    m_start = meshingAngle(m_phase, phaseAt(a, Isometry3d::Identity()), 0, phaseAt(b, m_poseB));
    // The section's origin is inside the first wheel, its y axis the common perpendicular.
    const Vector3d normal = pitchPlaneNormal(phaseAt(a, Isometry3d::Identity()), point);
    Isometry3d plane = Isometry3d::Identity();
    plane.linear() << normal, Vector3d::UnitX(), normal.cross(Vector3d::UnitX());
    plane.translation() = point - 5 * normalModule(a) * Vector3d::UnitX();
    m_toPlane = plane.inverse();
    m_point = m_toPlane * point;
  }

  [[nodiscard]] WormReport report(int steps, double wrong = 0) const {
    WormReport report;
    std::array<double, 2> least{1e300, 1e300}, most{-1e300, -1e300};
    // A turn of the second wheel moves its teeth along the normal by the radius times the cosine of its
    // helix.
    const double unit = pitchRadius(m_b) * std::cos(m_b.helixAngle) / normalModule(m_b);
    for (int step = 0; step < steps; ++step) {
      const double turn = 2 * pi / m_a.teeth * (step + 0.23) / steps;
      const double angle = m_start + m_phase.sign * m_a.teeth * turn / m_b.teeth + wrong * 2 * pi / m_b.teeth;
      const test::Section cut = cutBy(m_solidA, turnedBy(Isometry3d::Identity(), turn));
      report.overlap = std::max(report.overlap, depth(cut, angle) / normalModule(m_a));
      std::array<double, 2> play{};
      for (const int side : {0, 1}) {
        double low = 0, high = 0.1 * 2 * pi / m_b.teeth;
        for (int i = 0; i < 12; ++i) {
          const double middle = 0.5 * (low + high);
          (depth(cut, angle + (side == 0 ? middle : -middle)) > 1e-6 ? high : low) = middle;
        }
        play[side] = low * unit;
        least[side] = std::min(least[side], play[side]);
        most[side] = std::max(most[side], play[side]);
      }
      report.leastPlay = std::min(report.leastPlay, play[0] + play[1]);
      report.mostPlay = std::max(report.mostPlay, play[0] + play[1]);
      report.offCentre = std::max(report.offCentre, std::abs(play[0] - play[1]) / 2);
    }
    report.transmissionError = std::max(most[0] - least[0], most[1] - least[1]);
    return report;
  }

 private:
  /// Point contact is felt in the chords at once: finer than for export.
  static constexpr double kFine = 2e-4;

  [[nodiscard]] test::Section cutBy(const Solid& solid, const Isometry3d& pose) const {
    return test::Section::flat(moved(solid, m_toPlane * pose), 0);
  }
  [[nodiscard]] double depth(const test::Section& a, double angleB) const {
    const test::Section b = cutBy(m_solidB, turnedBy(m_poseB, angleB));
    return test::interpenetration({&a, Isometry3d::Identity()}, {&b, Isometry3d::Identity()}, m_point,
                                  6 * normalModule(m_a));
  }

  GearSpec m_a, m_b;
  Solid m_solidA, m_solidB;
  Isometry3d m_poseB, m_toPlane;
  MeshPhase m_phase;
  double m_start = 0;
  Vector3d m_point;
};

GearSpec crossedWheel(int teeth, double degrees) {
  GearSpec spec = helical(standardGear(GearKind::external, teeth, 2, 20), degrees * kWormDegree);
  // Backlash across the teeth is that along the circle times the cosine.
  spec.backlashAllowance = kWormPlay / 2;
  return spec;
}

void compareWormToBars(const WormReport& r) {
  const QString words = QString("overlap %1, TE %2, off centre %3, play %4..%5, in a section up to %6")
                            .arg(r.overlap)
                            .arg(r.transmissionError)
                            .arg(r.offCentre)
                            .arg(r.leastPlay)
                            .arg(r.mostPlay)
                            .arg(r.mostInSection);
  QVERIFY2(r.overlap <= 0.004, qPrintable(words));
  QVERIFY2(r.transmissionError <= 0.004, qPrintable(words));
  QVERIFY2(r.offCentre <= 0.005, qPrintable(words));
  QVERIFY2(std::abs(r.leastPlay - kWormPlay) <= 0.01, qPrintable(words));
  QVERIFY2(std::abs(r.mostPlay - kWormPlay) <= 0.01, qPrintable(words));
}

}  // namespace

/// Worms and their wheels: solids, and how they mesh, measured in sections by the independent checker.
class TestWormTeeth : public QObject {
  Q_OBJECT
 private slots:
  void pairsMesh_data() {
    QTest::addColumn<int>("starts");
    QTest::addColumn<int>("teeth");
    QTest::addColumn<double>("q");
    QTest::addColumn<int>("hand");
    QTest::addColumn<bool>("reversed");
    QTest::addColumn<double>("shift");
    const auto row = [](int starts, int teeth, double q, int hand, bool reversed = false, double shift = 0) {
      QTest::addRow("%d/%d, q %g, %s%s, x %g", starts, teeth, q, hand > 0 ? "right" : "left",
                    reversed ? ", reversed" : "", shift)
          << starts << teeth << q << hand << reversed << shift;
    };
    row(1, 20, 8, 1);
    row(1, 40, 10, -1);
    row(1, 60, 12.5, 1, true);
    row(2, 30, 10, 1);
    row(2, 20, 12.5, -1, true);
    row(2, 60, 8, -1);
    row(4, 40, 10, 1);
    row(4, 30, 8, -1);
    row(4, 20, 12.5, 1, true);
    row(3, 50, 9, 1, false, 0.3);
    row(1, 30, 10, -1, true, -0.2);
  }
  void pairsMesh() {
    QFETCH(int, starts);
    QFETCH(int, teeth);
    QFETCH(double, q);
    QFETCH(int, hand);
    QFETCH(bool, reversed);
    QFETCH(double, shift);
    const WormSections measured(wormPair(starts, teeth, 2, 2 * q, hand, shift), reversed);
    compareWormToBars(measured.report(4));
  }

  /// The check has to be able to fail: a wheel off by a tenth of a pitch, or of the wrong hand.
  void wrongPairsAreCaught() {
    const WormSections measured(wormPair(2, 30, 2, 20, 1));
    QVERIFY(measured.report(1, 0.1).overlap > 0.1);
    WormPair wrong = wormPair(2, 30, 2, 20, 1);
    wrong.wheel.helixAngle *= -1;
    QVERIFY(WormSections(wrong).report(1).overlap > 0.1);
    WormPair other = wormPair(2, 30, 2, 20, 1);
    other.wheel.mateRadius *= 1.25;  // cut by a thicker worm
    QVERIFY(std::abs(WormSections(other).report(1).leastPlay - kWormPlay) > 0.01);
  }

  void crossedHelicalPairsMesh_data() {
    QTest::addColumn<int>("a");
    QTest::addColumn<int>("b");
    QTest::addColumn<double>("helixA");
    QTest::addColumn<double>("helixB");
    QTest::newRow("at 90, right") << 18 << 24 << 45.0 << 45.0;
    QTest::newRow("at 90, left") << 20 << 20 << -50.0 << -40.0;
    QTest::newRow("at 60") << 15 << 25 << 35.0 << 25.0;
    QTest::newRow("at 20, opposite hands") << 22 << 31 << 40.0 << -20.0;
  }
  void crossedHelicalPairsMesh() {
    QFETCH(int, a);
    QFETCH(int, b);
    QFETCH(double, helixA);
    QFETCH(double, helixB);
    const CrossedSection measured(crossedWheel(a, helixA), crossedWheel(b, helixB));
    const WormReport r = measured.report(3);
    const QString words = QString("overlap %1, TE %2, off centre %3, play %4..%5")
                              .arg(r.overlap)
                              .arg(r.transmissionError)
                              .arg(r.offCentre)
                              .arg(r.leastPlay)
                              .arg(r.mostPlay);
    QVERIFY2(r.overlap <= 1e-4, qPrintable(words));
    QVERIFY2(r.transmissionError <= 1e-3, qPrintable(words));
    QVERIFY2(r.offCentre <= 1e-3, qPrintable(words));
    QVERIFY2(std::abs(r.leastPlay - kWormPlay) <= 0.004, qPrintable(words));
    QVERIFY(measured.report(1, 0.05).overlap > 0.05);
  }

  void solidsAreClosedManifoldAndOutward_data() {
    QTest::addColumn<int>("starts");
    QTest::addColumn<int>("teeth");
    QTest::addColumn<double>("q");
    QTest::addColumn<bool>("bored");
    for (const int starts : {1, 2, 4, 8}) {
      for (const bool bored : {false, true}) {
        const double q = bored ? 12.5 : 8;
        QTest::addRow("%d, q %g%s", starts, q, bored ? ", bored" : "")
            << starts << (starts == 8 ? 20 : 40) << q << bored;
      }
    }
  }
  void solidsAreClosedManifoldAndOutward() {
    QFETCH(int, starts);
    QFETCH(int, teeth);
    QFETCH(double, q);
    QFETCH(bool, bored);
    WormPair pair = wormPair(starts, teeth, 2, 2 * q, bored ? -1 : 1);
    if (bored) {
      pair.worm.bore = largestBore(pair.worm);
      pair.wheel.bore = 10;
      pair.wheel.body = GearBody::dressed;
    }
    for (const double tolerance : {kExportTolerance, kScreenTolerance, kFarTolerance}) {
      for (const GearSpec& spec : {pair.worm, pair.wheel}) {
        const Solid solid = gearSolid(spec, tolerance).value();
        const test::Topology topology = test::topologyOf(solid);
        QVERIFY(topology.closed);
        QVERIFY(topology.manifold);
        QCOMPARE(topology.degenerate, 0);
        QCOMPARE(topology.pieces, 1);
        const int windows = bodyWindows(spec) ? bodyWindows(spec)->count : 0;
        QCOMPARE(topology.genus, (bored ? 1 : 0) + windows);
        QVERIFY(signedVolume(solid) > 0);
        QCOMPARE(solid.positions.size(), solid.normals.size());
        const Eigen::AlignedBox3d box = boundsOf(solid);
        QVERIFY(std::abs(box.max().z() - spec.faceWidth / 2) < 1e-5);
        QVERIFY(std::abs(box.min().z() + spec.faceWidth / 2) < 1e-5);
        QVERIFY(box.max().x() < outerRadius(spec) + 1e-5);
        if (tolerance > kExportTolerance) continue;
        const double worst = test::worstNormalDegrees(solid, 1e-3);
        QVERIFY2(worst < 20, qPrintable(QString::number(worst)));
      }
    }
  }

  /// All sections of a worm are one section turned.
  void aWormHasTheVolumeOfItsSection() {
    for (const int starts : {1, 3}) {
      GearSpec spec = wormSpec(starts, 2, 9, 1, 20 * kWormDegree, 31);
      spec.bore = 5;
      const HalfTooth thread = toothOf(spec, 1e-6);
      double area = -pi * spec.bore * spec.bore / 4;
      for (std::size_t i = 0; i + 1 < thread.points.size(); ++i) {
        const ProfilePoint& a = thread.points[i];
        const ProfilePoint& b = thread.points[i + 1];
        area += starts * a.rad * b.rad * std::sin(a.gam - b.gam) * spec.module * spec.module;
      }
      const double volume = signedVolume(gearSolid(spec, kExportTolerance).value());
      QVERIFY(std::abs(volume / (area * spec.faceWidth) - 1) < 0.002);
    }
  }

  /// A plane through its axis shows a rack, and the mid section of its wheel is an involute gear.
  void midSectionsAreRackAndInvolute() {
    const WormPair pair = wormPair(2, 30, 2, 20, 1);
    const Solid worm = gearSolid(pair.worm, 1e-4).value();
    const Isometry3d upright(Eigen::AngleAxisd(pi / 2, Vector3d::UnitX()));  // the axis becomes -y
    const test::Section rack = test::Section::flat(moved(worm, upright), 0);
    const double tangent = std::tan(20 * kWormDegree) / std::cos(leadAngle(pair.worm));
    for (const double height : {-0.6, 0.0, 0.8}) {
      // The thread is centred on +x where z is 0; half of it is pi m / 4 less the allowance at the pitch
      // radius.
      const double half = 2 * (pi / 4 - kWormPlay / 4 - height * tangent);
      for (const double off : {-1e-3, 1e-3}) QCOMPARE(rack.contains({10 + 2 * height, half + off}), off < 0);
    }
    const test::Section wheel = test::Section::flat(gearSolid(pair.wheel, 1e-4).value(), 0);
    GearSpec plane = standardGear(GearKind::external, 30, 2, 1);
    plane.pressureAngle = std::atan(tangent);
    plane.backlashAllowance = kWormPlay / 2;
    for (const ProfilePoint& p : externalTooth(plane, 0.01).points) {
      const double rad = 2 * p.rad;
      const double away = wheel.distance({rad * std::cos(p.gam), rad * std::sin(p.gam)});
      QVERIFY2(away < 2e-3, qPrintable(QString("%1 at %2").arg(away).arg(p.rad)));
    }
  }

  /// Published example of a drive 2/30: see README.md of the teeth, section 2b.
  void measuresAreThoseOfTheBooks() {
    const GearSpec worm = wormSpec(2, 3, 22, 1, 20 * kWormDegree, 40);
    const GearSpec wheel = wormWheelSpec(30, 2, 3, 22, 1, 20 * kWormDegree, 30);
    QVERIFY(std::abs(leadAngle(worm) / kWormDegree - 7.7651660184) < 1e-9);
    QVERIFY(std::abs(normalModule(worm) - 2.97249050413) < 1e-10);
    QVERIFY(std::abs(normalModule(wheel) - 2.97249050413) < 1e-10);
    QVERIFY(std::abs(leadOf(worm) - 18.8495559215) < 1e-9);
    QVERIFY(std::abs(wormDistance(wheel) - 67) < 1e-12);
    QVERIFY(std::abs(axialModule(worm) - 3) < 1e-12);
    QVERIFY(std::abs(pitchRadius(worm) - 22) < 1e-12);
    QVERIFY(std::abs(normalPressureAngle(worm) / kWormDegree - 20) < 1e-9);
    QVERIFY(std::abs(normalPressureAngle(wheel) / kWormDegree - 20) < 1e-9);
    QVERIFY(std::abs(nominalTipRadius(worm) - 25) < 1e-12);
    QVERIFY(std::abs(nominalRootRadius(worm) - 18.25) < 1e-12);
    QVERIFY(std::abs(twistOf(worm, leadOf(worm)) - 2 * pi) < 1e-12);
    QVERIFY(std::abs(outerRadius(wheel) - (45 + 4.5)) < 1e-12);
  }

  void impossibleWormsAreRejected_data() {
    QTest::addColumn<bool>("ofWheel");
    QTest::addColumn<int>("change");
    QTest::addColumn<QString>("word");
    QTest::newRow("starts") << false << 0 << "9 starts";
    QTest::newRow("bore") << false << 1 << "bore of 38";
    QTest::newRow("lead") << false << 2 << "lead angle";
    QTest::newRow("shift") << false << 3 << "profile shift";
    QTest::newRow("pointed") << false << 4 << "pointed";
    QTest::newRow("thin") << false << 5 << "pitch diameter of 8";
    QTest::newRow("none") << false << 6 << "one start";
    QTest::newRow("as many starts as teeth") << true << 0 << "fewer starts";
    QTest::newRow("no worm") << true << 1 << "fewer starts";
    QTest::newRow("thin worm") << true << 2 << "too thin";
    QTest::newRow("wide") << true << 3 << "wider than its worm";
    QTest::newRow("bore of the wheel") << true << 4 << "bore of 90";
  }
  void impossibleWormsAreRejected() {
    QFETCH(bool, ofWheel);
    QFETCH(int, change);
    QFETCH(QString, word);
    WormPair pair = wormPair(2, 30, 3, 44, 1);
    QVERIFY(specDiagnostics(pair.worm).empty());
    QVERIFY(specDiagnostics(pair.wheel).empty());
    GearSpec& worm = pair.worm;
    GearSpec& wheel = pair.wheel;
    const std::array<std::function<void()>, 7> ofWorm{[&] { worm.teeth = 9; },
                                                      [&] { worm.bore = 38; },
                                                      [&] { worm = wormSpec(1, 3, 1000, 1, 0.35, 9); },
                                                      [&] { worm.profileShift = 0.1; },
                                                      [&] { worm.addendum *= 2.2; },
                                                      [&] { worm = wormSpec(1, 3, 4, 1, 0.35, 9); },
                                                      [&] { worm.teeth = 0; }};
    const std::array<std::function<void()>, 5> changes{
        [&] { wheel.mateTeeth = 30; }, [&] { wheel.mateTeeth = 0; }, [&] { wheel.mateRadius = 5; },
        [&] { wheel.faceWidth = 60; }, [&] { wheel.bore = 90; }};
    const auto at = static_cast<std::size_t>(change);
    ofWheel ? changes.at(at)() : ofWorm.at(at)();
    const Diagnostics found = specDiagnostics(ofWheel ? wheel : worm);
    QCOMPARE(found.size(), std::size_t{1});
    QVERIFY2(QString::fromStdString(found.front().message).contains(word), found.front().message.c_str());
  }

  /// The worm is part of what the wheel looks like.
  void cacheTellsWheelsOfOtherWormsApart() {
    GearCache cache;
    WormPair pair = wormPair(2, 30, 3, 44, 1);
    const auto first = cache.solid(pair.wheel, kFarTolerance).value();
    pair.wheel.mateRadius += 1;
    QVERIFY(cache.solid(pair.wheel, kFarTolerance).value() != first);
    pair.wheel.mateRadius -= 1;
    QVERIFY(cache.solid(pair.wheel, kFarTolerance).value() == first);
    pair.wheel.mateTeeth = 3;
    QVERIFY(cache.solid(pair.wheel, kFarTolerance).value() != first);
  }
};

QTEST_APPLESS_MAIN(TestWormTeeth)
#include "test_worm_teeth.moc"
