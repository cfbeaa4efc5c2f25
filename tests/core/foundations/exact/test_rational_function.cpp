#include <QTest>
#include <limits>
#include <random>

#include "core/foundations/exact/rational_function.h"

using namespace geargraph;

namespace {

const RatioRingPtr kRing = std::make_shared<RatioRing>(std::vector<std::string>{"i15", "i16", "i17", "i18"});

RationalFunction i(int label) {
  return RationalFunction::variable(kRing, label - 15);
}
RationalFunction whole(int value) {
  return RationalFunction::fromInteger(kRing, value);
}
QString text(const RationalFunction& function) {
  return QString::fromStdString(function.toText());
}
QString latex(const RationalFunction& function) {
  return QString::fromStdString(function.toLatex());
}

/// A function of a few random operations.
RationalFunction randomFunction(std::mt19937_64& random) {
  RationalFunction function = i(15 + static_cast<int>(random() % 4));
  for (int step = 0; step < 4; ++step) {
    const RationalFunction other =
        i(15 + static_cast<int>(random() % 4)) + whole(static_cast<int>(random() % 5) - 2);
    switch (random() % 4) {
      case 0:
        function += other;
        break;
      case 1:
        function -= other;
        break;
      case 2:
        function *= other;
        break;
      default:
        if (!other.isZero()) function /= other;
    }
  }
  return function;
}

}  // namespace

class RationalFunctionTest : public QObject {
  Q_OBJECT
 private slots:
  void monomialsPrintInThePapersOrder() {
    QCOMPARE(text(-i(15)), "-i15");
    QCOMPARE(text(-(i(15) * i(16) * i(17) * i(18))), "-i18*i17*i16*i15");
    QCOMPARE(latex(-(i(15) * i(16) * i(17) * i(18))), "-i_{18} i_{17} i_{16} i_{15}");
  }

  void quotientsPrintWithTheParenthesesTheyNeed() {
    QCOMPARE(text(i(15) * i(16) / i(17)), "i16*i15/i17");
    QCOMPARE(text(i(15) / (i(16) * i(17))), "i15/(i17*i16)");
    QCOMPARE(text(i(15) / (whole(2) * i(16))), "i15/(2*i16)");
    QCOMPARE(text((i(15) + i(16)) / (i(17) - whole(1))), "(i15 + i16)/(i17 - 1)");
    QCOMPARE(text(whole(1) / (i(15) * i(15))), "1/i15^2");
    QCOMPARE(text(-(whole(1) / i(15))), "-1/i15");
    QCOMPARE(latex(-(whole(1) / (i(15) * i(15)))), "-\\frac{1}{i_{15}^{2}}");
    QCOMPARE(text(whole(0)), "0");
    QCOMPARE(text(whole(-3)), "-3");
  }

  void equalFunctionsAreEqualValues() {
    const RationalFunction square = i(15) * i(15) - whole(1);
    QCOMPARE(text(square / (i(15) - whole(1))), "i15 + 1");
    QVERIFY(square / (whole(1) - i(15)) == -(i(15) + whole(1)));
    QVERIFY((i(15) - i(15)).isZero());
    QVERIFY(whole(1) / (whole(1) - i(16)) == -(whole(1) / (i(16) - whole(1))));
  }

  void theDefaultValueIsZero() {
    RationalFunction sum;
    QVERIFY(sum.isZero());
    sum -= i(15);
    QCOMPARE(text(sum), "-i15");
    const RationalFunction copy = RationalFunction();
    QVERIFY(copy == whole(0));
  }

  void valuesCommuteWithArithmetic() {
    std::mt19937_64 random(3);
    const std::vector<Rational> at{Rational(5, 7), Rational(11, 3), Rational(-2, 9), Rational(13)};
    for (int round = 0; round < 200; ++round) {
      const RationalFunction a = randomFunction(random);
      const RationalFunction b = randomFunction(random);
      const auto x = a.valueAt(at);
      const auto y = b.valueAt(at);
      QVERIFY(x && y);
      QCOMPARE(*(a + b).valueAt(at), *x + *y);
      QCOMPARE(*(a - b).valueAt(at), *x - *y);
      QCOMPARE(*(a * b).valueAt(at), *x * *y);
      if (!b.isZero()) QCOMPARE(*(a / b).valueAt(at), *x / *y);
    }
  }

  /// Laurent polynomials and fractions are two forms of one thing: a value that cancels back into the first
  /// form is the same value as one that never left it.
  void equalFunctionsAreEqualWhicheverWayTheyCame() {
    std::mt19937_64 random(11);
    for (int round = 0; round < 200; ++round) {
      RationalFunction laurent = i(15) / i(16) - whole(2) * i(17);
      for (int step = 0; step < 6; ++step) {
        const RationalFunction power = i(15 + static_cast<int>(random() % 4));
        laurent = random() % 2 == 0 ? laurent * power : laurent / power;
        if (random() % 3 == 0) laurent += whole(static_cast<int>(random() % 7) - 3);
      }
      const RationalFunction detour = i(18) * i(18) + i(15) - whole(3);
      QVERIFY((laurent * detour) / detour == laurent);
      QVERIFY((laurent / detour) * detour == laurent);
      QVERIFY(((laurent + whole(1) / detour) - whole(1) / detour) == laurent);
      QCOMPARE(text((laurent * detour) / detour), text(laurent));
    }
  }

  void numbersBeyondTheSmallFormStayExact() {
    RationalFunction large = i(15);
    RationalFunction power = whole(1);
    for (int k = 0; k < 100; ++k) large *= whole(3);
    for (int k = 0; k < 300; ++k) power *= i(16);
    QCOMPARE(text(large), "515377520732011331036461129765621272702107522001*i15");
    QCOMPARE(text(power), "i16^300");
    for (int k = 0; k < 100; ++k) large /= whole(3);
    for (int k = 0; k < 299; ++k) power /= i(16);
    QVERIFY(large == i(15));
    QVERIFY(power == i(16));
    const RationalFunction most =
        RationalFunction::fromInteger(kRing, std::numeric_limits<std::int64_t>::min());
    QCOMPARE(text(most), "-9223372036854775808");
    QCOMPARE(text(most + most), "-18446744073709551616");
    QVERIFY((most - most).isZero());
  }

  void aProductIsSubtractedInOneStep() {
    std::mt19937_64 random(5);
    for (int round = 0; round < 200; ++round) {
      const RationalFunction a = randomFunction(random);
      const RationalFunction b = randomFunction(random);
      const RationalFunction c = randomFunction(random);
      RationalFunction fused = a;
      fused.subtractProduct(b, c);
      QVERIFY(fused == a - b * c);
    }
    RationalFunction sum;
    sum.subtractProduct(i(15), i(16));
    QCOMPARE(text(sum), "-i16*i15");
  }

  void aPoleHasNoValue() {
    const std::vector<Rational> at{1, 1, 1, 1};
    QVERIFY(!(whole(1) / (i(15) - i(16))).valueAt(at).has_value());
  }

  void aRingWithValuesTellsWhatVanishesThere() {
    const auto ring = std::make_shared<RatioRing>(std::vector<std::string>{"i3", "i4"},
                                                  std::vector<RatioRing::Teeth>{{10, 20}, {15, 30}});
    const RationalFunction difference =
        RationalFunction::variable(ring, 0) - RationalFunction::variable(ring, 1);
    QVERIFY(!difference.isZero());
    QVERIFY(difference.vanishesAtValues());
    QVERIFY(!RationalFunction::variable(ring, 0).vanishesAtValues());
    QVERIFY(!(i(15) - i(16)).vanishesAtValues());
  }
};

QTEST_APPLESS_MAIN(RationalFunctionTest)
#include "test_rational_function.moc"
