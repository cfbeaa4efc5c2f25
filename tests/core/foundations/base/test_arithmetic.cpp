#include <QTest>

#include "core/foundations/base/arithmetic.h"

using namespace geargraph;

/// Expressions of exact numbers, as people type them.
class ArithmeticTest : public QObject {
  Q_OBJECT

 private slots:
  void expressionsAreExact_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("expected");
    const auto row = [](const char* text, const char* expected) { QTest::newRow(text) << text << expected; };
    row("2*3", "6");
    row("1/3+1/5", "8/15");
    row("100/22", "50/11");
    row(" 1 - 2 - 3 ", "-4");
    row("2 + 3 * 4", "14");
    row("(2 + 3) * 4", "20");
    row("8 / 4 / 2", "1");
    row("-2^2", "-4");
    row("(-2)^2", "4");
    row("2^-3", "1/8");
    row("2^(-3)", "1/8");
    row("(2/3)^(1-3)", "9/4");
    row("0^0", "1");
    row("- -3", "3");
    row("2*-3", "-6");
    row("0.1+0.2", "3/10");
    row("1e-3*1e3", "1");
    row("1e3-1", "999");
    row("-22/7", "-22/7");
    row("\xE2\x88\x92"
        "3\xC3\x97"
        "4",
        "-12");
    row("3\xC2\xB7"
        "4",
        "12");
    row("12\xC3\xB7"
        "8",
        "3/2");
    row("9007199254740993*3", "27021597764222979");
    row("2^1000/2^999", "2");
  }
  void expressionsAreExact() {
    QFETCH(QString, text);
    QFETCH(QString, expected);
    const auto value = arithmeticFromText(text.toStdString());
    QVERIFY(value);
    QCOMPARE(QString::fromStdString(value->toString()), expected);
  }

  void whatIsNoExpressionIsRejected_data() {
    QTest::addColumn<QString>("text");
    for (const char* const text :
         {"",        " ",    "2*",    "*2",     "2 3",     "1 000", "(2",  "2)",  "()",   "1/0",
          "1/(2-2)", "0^-1", "2^0.5", "2^1001", "2^-1001", "2^2^2", "2x",  "2,5", "1..2", ".",
          "e3",      "1e",   "--",    "2^",     "7 mm",    "NaN",   "inf", "0x10"})
      QTest::newRow(text) << text;
    QTest::newRow("deep") << QString(65, '(') + "1" + QString(65, ')');
    QTest::newRow("huge") << QString("(10^1000)^1000");
    QTest::newRow("long") << QString("1+").repeated(6000) + "1";
    QTest::newRow("many digits") << QString(5000, '9') + "*2";
  }
  void whatIsNoExpressionIsRejected() {
    QFETCH(QString, text);
    QVERIFY(!arithmeticFromText(text.toStdString()));
  }

  void deepAndLongExpressionsAreRead() {
    const QString deep = QString(64, '(') + "1" + QString(64, ')');
    QCOMPARE(*arithmeticFromText(deep.toStdString()), Rational(1));
    const QString sum = QString("1+").repeated(4999) + "1";
    QCOMPARE(*arithmeticFromText(sum.toStdString()), Rational(5000));
  }
};

QTEST_GUILESS_MAIN(ArithmeticTest)
#include "test_arithmetic.moc"
