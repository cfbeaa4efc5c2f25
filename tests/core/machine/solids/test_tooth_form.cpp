#include <Eigen/Core>
#include <QTest>
#include <cmath>

#include "core/machine/solids/spec_diagnostics.h"
#include "core/machine/teeth/half_tooth.h"
#include "core/machine/teeth/involute.h"

using namespace geargraph;

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kAlpha = 20 * kPi / 180;

GearSpec gear(GearKind kind, int teeth, double shift = 0, double backlashAllowance = 0) {
  GearSpec spec = standardGear(kind, teeth, 1, 5);
  spec.profileShift = shift;
  spec.backlashAllowance = backlashAllowance;
  return spec;
}

GearSpec bevel(int teeth, double coneDegrees, double shift = 0) {
  GearSpec spec = gear(GearKind::bevel, teeth, shift);
  spec.coneAngle = coneDegrees * kPi / 180;
  spec.faceWidth = 1;
  return spec;
}

/// The cutter, in its own plane: a rack tooth with straight flanks and two rounded corners, its middle at x =
/// 0, its tip `depth` below the datum. Distance to its surface, negative inside.
struct RackCutter {
  double halfAtDatum, depth, rho;

  [[nodiscard]] double distance(double x, double y) const {
    x = std::abs(x);
    // The straight flank runs from the datum down, closing in; its outward normal is (cos a, -sin a).
    const double flank = (x - halfAtDatum) * std::cos(kAlpha) - y * std::sin(kAlpha);
    const double cy = rho - depth;
    const double cx = halfAtDatum + cy * std::tan(kAlpha) - rho / std::cos(kAlpha);
    const double dx = x - cx;
    const double dy = y - cy;
    const bool atCorner = dy < dx * std::tan(-kAlpha) && dx > 0;
    if (atCorner) return std::hypot(dx, dy) - rho;
    return std::max(flank, -depth - y);
  }
};

/// Least distance of a fixed point of the gear to the cutter while the blank rolls past it.
double leastDistance(const RackCutter& rack, const GearSpec& spec, double rad, double gam) {
  const double rp = spec.teeth / 2.0;
  const auto at = [&](double turn) {
    // Space k = 0 lies at gam = pi/z from the tooth; turned by `turn`, the rack has moved by rp * turn.
    const double angle = gam - kPi / spec.teeth + turn;
    const double x = rad * std::sin(angle) - rp * turn;
    const double y = rad * std::cos(angle) - rp;
    return rack.distance(x, y);
  };
  double best = 1e9;
  double where = 0;
  constexpr int kSteps = 4000;
  for (int i = 0; i <= kSteps; ++i) {
    const double turn = -1.2 + 2.4 * i / kSteps;
    if (at(turn) < best) {
      best = at(turn);
      where = turn;
    }
  }
  double step = 2.4 / kSteps;
  for (int i = 0; i < 60; ++i, step *= 0.6) {
    for (const double turn : {where - step, where + step}) {
      if (at(turn) < best) {
        best = at(turn);
        where = turn;
      }
    }
  }
  return best;
}

bool onTip(const HalfTooth& tooth, const ProfilePoint& p) {
  return p.rad == tooth.tipRad;
}

}  // namespace

class ToothFormTest : public QObject {
  Q_OBJECT
 private slots:
  void inverseInvoluteUndoesTheInvolute() {
    for (double angle = 0.001; angle < 1.3; angle += 0.0137) {
      QVERIFY(std::abs(inverseInvolute(involute(angle)) - angle) < 1e-12);
    }
  }

  void shiftSumUndoesTheCentreDistance() {
    QVERIFY(std::abs(centreDistance(50, 0, kAlpha) - 25) < 1e-12);
    for (const double sum : {-0.3, 0.2, 0.9}) {
      QVERIFY(std::abs(shiftSumFor(44, centreDistance(44, sum, kAlpha), kAlpha) - sum) < 1e-12);
    }
  }

  void flanksAreTheInvoluteOfTheBaseCircle() {
    for (const int teeth : {8, 12, 17, 40, 100}) {
      for (const double shift : {0.0, 0.5}) {
        const GearSpec spec = gear(GearKind::external, teeth, shift, 0.02);
        const HalfTooth tooth = externalTooth(spec, 0.002);
        const double rb = teeth / 2.0 * std::cos(kAlpha);
        const double thickness = kPi / 2 + 2 * shift * std::tan(kAlpha) - 0.02;
        int seen = 0;
        for (const ProfilePoint& p : tooth.points) {
          if (p.rad < tooth.formRad || (onTip(tooth, p) && p.normalGam == 0)) continue;
          // The thread unwound from the base circle is as long as the arc it left.
          const double thread = std::sqrt(p.rad * p.rad - rb * rb);
          const double leaves = p.gam + thread / rb - std::acos(rb / p.rad);
          QVERIFY(std::abs((leaves - (thickness / teeth + involute(kAlpha))) * rb) < 1e-9);
          ++seen;
        }
        QVERIFY(seen >= 3);
      }
    }
  }

  /// Every point below the tip is touched by the rolling rack and never cut off by it.
  void rootsAreWhatTheRackCuts() {
    int seen = 0;
    for (const int teeth : {6, 8, 12, 17, 30, 60}) {
      for (const double shift : {-0.3, 0.0, 0.5}) {
        const GearSpec spec = gear(GearKind::external, teeth, shift);
        if (!specDiagnostics(spec).empty()) continue;
        const HalfTooth tooth = externalTooth(spec, 0.002);
        const double space = kPi / 2 - 2 * shift * std::tan(kAlpha);
        const RackCutter cutter{space / 2, spec.dedendum - shift, spec.rootRadius};
        for (const ProfilePoint& p : tooth.points) {
          if (onTip(tooth, p)) continue;
          ++seen;
          const double distance = leastDistance(cutter, spec, p.rad, p.gam);
          QVERIFY2(
              distance > -1e-7 && distance < 1e-6,
              qPrintable(QString("z %1 x %2 rad %3: %4").arg(teeth).arg(shift).arg(p.rad).arg(distance)));
        }
      }
    }
    QVERIFY2(seen > 200, qPrintable(QString::number(seen)));
  }

  void undercutBeginsBelowSeventeenTeeth() {
    QVERIFY(!externalTooth(gear(GearKind::external, 18), 0.002).undercut);
    QVERIFY(externalTooth(gear(GearKind::external, 17), 0.002).undercut);  // 2 / sin^2 20 deg = 17.097
    // x = 1 - 8 sin^2(20 deg) / 2 = 0.532 is just enough for 8 teeth.
    QVERIFY(externalTooth(gear(GearKind::external, 8, 0.53), 0.002).undercut);
    QVERIFY(!externalTooth(gear(GearKind::external, 8, 0.54), 0.002).undercut);
  }

  void pointedTeethAreShortenedToTheNarrowestLand() {
    const HalfTooth tooth = externalTooth(gear(GearKind::external, 8, 0.8), 0.002);
    QVERIFY(tooth.shortened);
    QVERIFY(std::abs(2 * tooth.tipRad * tooth.tipHalfAngle - kNarrowestLand) < 1e-9);
    QVERIFY(!externalTooth(gear(GearKind::external, 40, 0.3), 0.002).shortened);
  }

  void ringSpacesAreTheTeethOfAnExternalGear() {
    const GearSpec ring = gear(GearKind::internal, 60, 0.2, 0.03);
    const HalfTooth tooth = ringTooth(ring, 0.002);
    const double rb = 30 * std::cos(kAlpha);
    const double space = kPi / 2 + 0.4 * std::tan(kAlpha) + 0.03;
    int seen = 0;
    for (const ProfilePoint& p : tooth.points) {
      if (p.rad > tooth.formRad || (onTip(tooth, p) && p.normalGam == 0)) continue;
      const double thread = std::sqrt(p.rad * p.rad - rb * rb);
      const double leaves = kPi / 60 - p.gam + thread / rb - std::acos(rb / p.rad);
      QVERIFY(std::abs((leaves - (space / 60 + involute(kAlpha))) * rb) < 1e-9);
      ++seen;
    }
    QVERIFY(seen >= 3);
    QCOMPARE(tooth.rootRad, 30 + 1.25 + 0.2);
    QCOMPARE(tooth.tipRad, 30 - 1 + 0.2);
  }

  /// All fillet points lie at one distance from one centre, which is rho below the root circle.
  void ringFilletsTouchRootAndFlank() {
    const HalfTooth tooth = ringTooth(gear(GearKind::internal, 36), 0.0005);
    std::vector<ProfilePoint> fillet;
    for (const ProfilePoint& p : tooth.points) {
      if (p.rad <= tooth.rootRad && p.rad >= tooth.formRad - 1e-12 && p.gam < kPi / 36 - 1e-12)
        fillet.push_back(p);
    }
    const ProfilePoint first = fillet.front();
    const double rc = tooth.rootRad - 0.25;
    for (const ProfilePoint& p : fillet) {
      const double turn = p.gam - first.gam;
      const double distance = std::sqrt(p.rad * p.rad + rc * rc - 2 * p.rad * rc * std::cos(turn));
      if (p.rad < tooth.rootRad) QVERIFY(std::abs(distance - 0.25) < 1e-9);
    }
    QVERIFY(fillet.size() > 5);
  }

  void bevelFlanksAreSphericalInvolutes() {
    for (const double cone : {15.0, 33.0, 45.0, 63.0, 85.0, 105.0, 120.0}) {
      const GearSpec spec = bevel(30, cone, 0.1);
      const HalfTooth tooth = bevelTooth(spec, 0.002);
      int seen = 0;
      for (const ProfilePoint& p : tooth.points) {
        if (p.rad < tooth.formRad || (onTip(tooth, p) && p.normalGam == 0)) continue;
        const double mu = 2 * std::sin(spec.coneAngle) / spec.teeth;
        const double off = (p.gam - sphericalInvoluteHalfAngle(spec, p.rad)) * std::sin(p.rad) / mu;
        QVERIFY2(std::abs(off) < 1e-9, qPrintable(QString::number(off) + ' ' + QString::number(cone)));
        ++seen;
      }
      QVERIFY(seen >= 3);
    }
  }

  void bevelToothIsHalfAPitchThickOnThePitchCone() {
    for (const double cone : {20.0, 45.0, 70.0}) {
      const GearSpec spec = bevel(24, cone);
      QVERIFY(std::abs(sphericalInvoluteHalfAngle(spec, spec.coneAngle) - kPi / 48) < 1e-12);
    }
  }

  /// With a small cone a bevel tooth is the spur tooth of the same number of teeth.
  void bevelToothOfASmallConeIsASpurTooth() {
    const GearSpec spec = bevel(20, 0.7);
    GearSpec spur = gear(GearKind::external, 20);
    spur.rootRadius = spec.rootRadius;
    const HalfTooth cone = bevelTooth(spec, 0.002);
    const double perModule = 2 * std::sin(spec.coneAngle) / 20;
    int seen = 0;
    for (const ProfilePoint& p : cone.points) {
      if (p.rad < cone.formRad) continue;
      const double rad = std::tan(p.rad) / perModule;
      if (onTip(cone, p)) continue;
      ++seen;
      QVERIFY(std::abs(p.gam - involuteHalfAngle(spur, rad)) * rad < 2e-3);
    }
    QVERIFY(std::abs(cone.tipRad / perModule - 11) < 2e-3);
    QVERIFY(std::abs(cone.rootRad / perModule - 8.75) < 2e-3);
    QVERIFY(seen >= 3);
  }

  /// Undercut of a bevel is decided by z / cos d.
  void bevelUndercutFollowsTheVirtualTeeth() {
    QVERIFY(bevelTooth(bevel(14, 30), 0.002).undercut);   // 16.2 virtual teeth
    QVERIFY(!bevelTooth(bevel(14, 45), 0.002).undercut);  // 19.8
  }

  void noChordIsFartherThanTheTolerance_data() {
    QTest::addColumn<int>("kind");
    QTest::addColumn<int>("teeth");
    QTest::addColumn<double>("cone");
    QTest::newRow("pinion 8") << 0 << 8 << 0.0;
    QTest::newRow("spur 40") << 0 << 40 << 0.0;
    QTest::newRow("ring 60") << 1 << 60 << 0.0;
    QTest::newRow("bevel 20 at 27") << 2 << 20 << 26.565;
    QTest::newRow("bevel 40 at 63") << 2 << 40 << 63.435;
  }
  void noChordIsFartherThanTheTolerance() {
    QFETCH(int, kind);
    QFETCH(int, teeth);
    QFETCH(double, cone);
    GearSpec spec = gear(static_cast<GearKind>(kind), teeth);
    spec.coneAngle = cone * kPi / 180;
    const auto make = [&](double tolerance) {
      if (kind == 0) return externalTooth(spec, tolerance);
      return kind == 1 ? ringTooth(spec, tolerance) : bevelTooth(spec, tolerance);
    };
    // Bevels are measured in modules on the developed back cone.
    const double mu = 2 * std::sin(spec.coneAngle) / teeth;
    const auto flat = [&](const ProfilePoint& p) {
      const double r = kind == 2 ? (std::tan(p.rad - spec.coneAngle) + std::tan(spec.coneAngle)) / mu : p.rad;
      const double a = kind == 2 ? p.gam * std::cos(spec.coneAngle) : p.gam;
      return Eigen::Vector2d(r * std::cos(a), r * std::sin(a));
    };
    const HalfTooth coarse = make(0.002);
    double worst = 0;
    for (const ProfilePoint& p : make(1e-6).points) {
      double nearest = 1e9;
      for (std::size_t i = 0; i + 1 < coarse.points.size(); ++i) {
        const Eigen::Vector2d a = flat(coarse.points[i]);
        const Eigen::Vector2d d = flat(coarse.points[i + 1]) - a;
        const double along = std::clamp((flat(p) - a).dot(d) / std::max(d.squaredNorm(), 1e-300), 0.0, 1.0);
        nearest = std::min(nearest, (flat(p) - a - along * d).norm());
      }
      worst = std::max(worst, nearest);
    }
    QVERIFY2(worst < 0.00225, qPrintable(QString::number(worst)));
    QVERIFY2(worst > 0.0004, qPrintable(QString::number(worst)));  // not sampled to death either
  }
};

QTEST_APPLESS_MAIN(ToothFormTest)
#include "test_tooth_form.moc"
