#include <QTest>

#include "core/foundations/exact/linear_maximum.h"

using namespace geargraph;

namespace {

LinearBound atMost(std::vector<Rational> coefficients, const Rational& bound) {
  return {std::move(coefficients), bound};
}

}  // namespace

class LinearMaximumTest : public QObject {
  Q_OBJECT

 private slots:
  void aPolygon() {
    const std::vector<LinearBound> bounds{atMost({1, 0}, 4), atMost({0, 2}, 12), atMost({3, 2}, 18),
                                          atMost({-1, 0}, 0), atMost({0, -1}, 0)};
    QCOMPARE(linearMaximum(bounds, std::vector<Rational>{3, 5}), std::optional(Rational(36)));
    QCOMPARE(linearMaximum(bounds, std::vector<Rational>{-1, -1}), std::optional(Rational(0)));
  }

  /// Unknowns may be below 0, and the answer is a fraction.
  void unknownsOfAnySign() {
    const std::vector<LinearBound> bounds{atMost({-3, 0}, 1), atMost({0, -7}, 2), atMost({1, 1}, 0)};
    QCOMPARE(linearMaximum(bounds, std::vector<Rational>{-1, -1}),
             std::optional(Rational(1, 3) + Rational(2, 7)));
    QCOMPARE(linearMaximum(bounds, std::vector<Rational>{1, 0}), std::optional(Rational(2, 7)));
  }

  void whatHasNoBound() {
    const std::vector<LinearBound> bounds{atMost({1, -1}, 1)};
    QVERIFY(!linearMaximum(bounds, std::vector<Rational>{1, 1}));
    QCOMPARE(linearMaximum(bounds, std::vector<Rational>{1, -1}), std::optional(Rational(1)));
    QVERIFY(!linearMaximum({}, std::vector<Rational>{1}));
    QCOMPARE(linearMaximum({}, std::vector<Rational>{0}), std::optional(Rational(0)));
  }

  /// Beale's example, at which the rule of the steepest gain cycles.
  void itDoesNotCycle() {
    const std::vector<LinearBound> bounds{atMost({Rational(1, 4), -60, Rational(-1, 25), 9}, 0),
                                          atMost({Rational(1, 2), -90, Rational(-1, 50), 3}, 0),
                                          atMost({0, 0, 1, 0}, 1),
                                          atMost({-1, 0, 0, 0}, 0),
                                          atMost({0, -1, 0, 0}, 0),
                                          atMost({0, 0, -1, 0}, 0),
                                          atMost({0, 0, 0, -1}, 0)};
    QCOMPARE(linearMaximum(bounds, std::vector<Rational>{Rational(3, 4), -150, Rational(1, 50), -6}),
             std::optional(Rational(1, 20)));
    QVERIFY(!linearMaximum(bounds, std::vector<Rational>{Rational(3, 4), -150, Rational(1, 50), -6}, 0));
  }
};

QTEST_APPLESS_MAIN(LinearMaximumTest)
#include "test_linear_maximum.moc"
