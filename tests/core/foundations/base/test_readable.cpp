#include <QTest>

#include "core/foundations/base/locale.h"
#include "core/foundations/base/readable.h"

using namespace geargraph;

class ReadableTest : public QObject {
  Q_OBJECT

 private slots:
  void shortFractionsStayLongOnesBecomeDecimals() {
    QCOMPARE(readableNumber(Rational(-8, 3)), std::string("-8/3"));
    QCOMPARE(readableNumber(Rational(12345, 679)), std::string("12345/679"));
    QCOMPARE(readableNumber(Rational(-5080983, 250000)), std::string("-20.3239"));
    QCOMPARE(readableNumber(Rational(-705894, 3125)), std::string("-225.886"));
    QCOMPARE(readableNumber(Rational(1234567890123)), std::string("1234567890123"));
    QCOMPARE(readableNumber(Rational(0)), std::string("0"));
  }

  void wholeNumbersOfAnyLengthAreNoFractions() {
    QVERIFY(!isLongFraction("1234567890123"));
    QVERIFY(!isLongFraction("-1000/999"));
    QVERIFY(isLongFraction("-10000/999"));
  }

  void decimalsHaveTheSignOfTheLanguage() {
    setDecimalSign(',');
    const std::string german = readableNumber(Rational(-5080983, 250000));
    setDecimalSign('.');
    QCOMPARE(german, std::string("-20,3239"));
    QCOMPARE(readableNumber(-0.0), std::string("0"));
  }
};

QTEST_APPLESS_MAIN(ReadableTest)
#include "test_readable.moc"
