#include <flint/ulong_extras.h>

#include <QTest>
#include <random>

#include "core/foundations/exact/fields.h"

using namespace geargraph;

class PrimeFieldTest : public QObject {
  Q_OBJECT
 private slots:
  void theSeedsGiveTwoPrimesOf61Bits() {
    const PrimeField first(PrimeField::kFirstSeed);
    const PrimeField second(PrimeField::kSecondSeed);
    QVERIFY(first.prime() != second.prime());
    for (const PrimeField* field : {&first, &second}) {
      QCOMPARE(field->prime() >> 60U, std::uint64_t{1});
      QVERIFY(n_is_prime(field->prime()) != 0);
    }
  }

  void arithmeticIsThatOfWholeNumbers() {
    const PrimeField field;
    std::mt19937_64 random(1);
    std::uniform_int_distribution<std::int64_t> any(-2'000'000'000, 2'000'000'000);
    for (int i = 0; i < 1000; ++i) {
      const std::int64_t a = any(random);
      const std::int64_t b = any(random);
      const auto x = field.fromInteger(a);
      const auto y = field.fromInteger(b);
      QCOMPARE(field.add(x, y), field.fromInteger(a + b));
      QCOMPARE(field.subtract(x, y), field.fromInteger(a - b));
      QCOMPARE(field.multiply(x, y), field.fromInteger(a * b));
      QCOMPARE(field.negate(x), field.fromInteger(-a));
    }
  }

  void aNumberTimesItsInverseIsOne() {
    const PrimeField field;
    ResidueStream stream(field, 2);
    for (int i = 0; i < 1000; ++i) {
      const auto a = stream.next();
      QCOMPARE(field.multiply(a, field.inverse(a)), field.one());
    }
  }

  void fractionsMapToQuotients() {
    const PrimeField field;
    const auto third = field.fromRational(Rational(-7, 3));
    QVERIFY(third.has_value());
    QCOMPARE(field.multiply(*third, field.fromInteger(3)), field.fromInteger(-7));
    const Rational multiple =
        Rational(1) / (Rational(static_cast<std::int64_t>(field.prime())) * Rational(2));
    QVERIFY(!field.fromRational(multiple).has_value());
  }

  void aSumThatVanishesIsZeroInTheDoubleToo() {
    const ModularDoubleField field;
    ModularDouble third = field.quotient(field.one(), field.fromInteger(3));
    ModularDouble sum = field.one();
    for (int i = 0; i < 3; ++i) field.subtractProduct(sum, third, field.one());
    QVERIFY(field.isZero(sum));
    QCOMPARE(sum.number, 0.0);  // 1 - 1/3 - 1/3 - 1/3 is 1.1e-16 in plain doubles
  }
};

QTEST_APPLESS_MAIN(PrimeFieldTest)
#include "test_prime_field.moc"
