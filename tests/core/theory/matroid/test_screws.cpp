#include <QTest>
#include <cmath>
#include <numbers>
#include <random>

#include "core/theory/matroid/screw.h"

using namespace geargraph;

namespace {

double drawn(std::mt19937_64& random) {
  return static_cast<double>(random() % 2001) / 100 - 10;
}
Vector3 vectorDrawn(std::mt19937_64& random) {
  const double x = drawn(random);
  const double y = drawn(random);
  return {x, y, drawn(random)};
}

/// `v` turned about the unit vector u, component by component (Rodrigues).
Vector3 turned(const Vector3& v, const Vector3& u, double angle) {
  const Vector3 across{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
  const double along = (u[0] * v[0] + u[1] * v[1] + u[2] * v[2]) * (1 - std::cos(angle));
  Vector3 result{};
  for (std::size_t i = 0; i < 3; ++i) {
    result[i] = v[i] * std::cos(angle) + across[i] * std::sin(angle) + u[i] * along;
  }
  return result;
}

bool areClose(const Vector3& a, const Vector3& b, double within) {
  return length(a - b) <= within;
}

}  // namespace

class ScrewsTest : public QObject {
  Q_OBJECT
 private slots:
  /// Turn the pitch point by a little about the line, either way: its way over the angle is the moment.
  void theMomentIsTheVelocityOfThePitchPoint() {
    std::mt19937_64 random(6);
    constexpr double kStep = 1e-4;
    int checked = 0;
    for (int round = 0; round < 100; ++round) {
      const Vector3 pitchPoint = vectorDrawn(random);
      const Vector3 axisPoint = vectorDrawn(random);
      Vector3 direction = vectorDrawn(random);
      if (length(direction) < 1) continue;
      ++checked;
      direction = unit(direction);
      const Vector3 arm = pitchPoint - axisPoint;
      const Vector3 way = turned(arm, direction, kStep) - turned(arm, direction, -kStep);
      const Screw<double> screw = screwAbout(pitchPoint, axisPoint, direction);
      QVERIFY(areClose(screw.moment, (1 / (2 * kStep)) * way, 1e-6));
      QVERIFY(areClose(screw.direction, direction, 0));
    }
    QVERIFY2(checked > 80, qPrintable(QString::number(checked)));
  }

  void aPointOnTheAxisStandsStill() {
    const ExactVector3 point{1, 2, Rational(3, 7)};
    const ExactVector3 direction{Rational(2, 3), -1, 5};
    const Screw<Rational> screw = screwAbout(point, point + Rational(9) * direction, direction);
    QVERIFY(screw.moment == (ExactVector3{0, 0, 0}));
  }

  /// About z, a point at x = 2 moves along +y: the right-hand rule, in whole numbers.
  void theRightHandRuleHolds() {
    const Screw<Rational> screw = screwAbout<Rational>({2, 0, 0}, {0, 0, 0}, {0, 0, 1});
    QVERIFY(screw.moment == (ExactVector3{0, 2, 0}));
    const Twist<Rational> twist = screw * Rational(-3);
    QVERIFY(twist.angular == (ExactVector3{0, 0, -3}));
    QVERIFY(twist.linear == (ExactVector3{0, -6, 0}));
  }

  void theOffsetRotationTurnsAboutX() {
    for (int degrees = -180; degrees <= 180; degrees += 15) {
      const double phi = degrees * std::numbers::pi / 180;
      const Vector3Of<Vector3> rows = offsetRotation(phi);
      for (const Vector3& axis : {Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}}) {
        const Vector3 image{dot(rows[0], axis), dot(rows[1], axis), dot(rows[2], axis)};
        QVERIFY(areClose(image, turned(axis, {1, 0, 0}, phi), 1e-12));
      }
      QVERIFY(areClose(offsetDirection(phi), turned({0, 0, 1}, {1, 0, 0}, phi), 1e-12));
    }
  }
};

QTEST_APPLESS_MAIN(ScrewsTest)
#include "test_screws.moc"
