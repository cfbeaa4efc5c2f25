#include <QTest>
#include <cmath>
#include <numbers>

#include "core/theory/pose/angle.h"

using namespace geargraph;

namespace {

Rational number(const char* text) {
  return Rational::fromText(text).value();
}

bool isNear(double a, double b) {
  return std::abs(a - b) <= 4e-16 * std::max(1.0, std::abs(b));
}

}  // namespace

class AngleTest : public QObject {
  Q_OBJECT
 private slots:
  void anglesBelowHalfATurnAreLeftAlone() {
    QCOMPARE(reducedAngle(0, {1, 2}), 0.5);
    QCOMPARE(reducedAngle(0, number("-3.14")), -3.14);
    QCOMPARE(reducedAngle({1, 4}, 0), std::numbers::pi / 2);
    QVERIFY(isNear(reducedAngle({1, 4}, {1, 2}), std::numbers::pi / 2 + 0.5));
  }

  void wholeTurnsAreTakenOffExactly() {
    QCOMPARE(reducedAngle(7, 0), 0.0);
    QCOMPARE(reducedAngle(number("1e4000") + Rational(1, 8), 0), std::numbers::pi / 4);
    QCOMPARE(reducedAngle(Rational(-5, 4), 0), -std::numbers::pi / 2);
    QCOMPARE(reducedAngle({1, 2}, 0), std::numbers::pi);
    QCOMPARE(reducedAngle({-1, 2}, 0), std::numbers::pi);
  }

  void radiansOfAnySizeAreAsPreciseAsSmallOnes() {
    // Sine and cosine of 1e22 are a known test of the reduction.
    const double angle = reducedAngle(0, number("1e22"));
    QVERIFY(isNear(std::sin(angle), -0.8522008497671888));
    QVERIFY(isNear(std::cos(angle), 0.5232147853951389));
    // Doubles are exact numbers, and the C library reduces them exactly.
    for (const double value : {1e5, 123456789.0, 1e22, 6.5e150, 1.7976931348623157e308}) {
      const double reduced = reducedAngle(0, Rational::fromDouble(value));
      QVERIFY(std::abs(reduced) <= std::numbers::pi);
      QVERIFY(isNear(std::sin(reduced), std::sin(value)) && isNear(std::cos(reduced), std::cos(value)));
    }
  }

  void oppositeAnglesAreOpposite() {
    for (const char* text : {"1e9", "12345/678", "1e100"}) {
      QCOMPARE(reducedAngle(0, -number(text)), -reducedAngle(0, number(text)));
    }
  }
};

QTEST_APPLESS_MAIN(AngleTest)
#include "test_angle.moc"
