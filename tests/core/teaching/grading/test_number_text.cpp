#include <QTest>

#include "core/teaching/grading/number_text.h"

namespace geargraph {

class NumberTextTest : public QObject {
  Q_OBJECT

  static QString read(const char* text) {
    const WrittenNumber number = readNumber(text);
    if (number.fault == NumberFault::ambiguous) return "ambiguous";
    if (number.fault == NumberFault::notANumber) return "no number";
    return QString::fromStdString(number.value.toString());
  }
  static bool agrees(const char* text, const Rational& expected) {
    return readNumber(text).agreesWith(expected);
  }

 private slots:
  void notationsOfOneNumber() {
    for (const char* text : {"-3/4", "−3/4", "–3/4", " - 3 / 4 ", "-0.75", "-0,75", "-.75", "-(3/4)", "3/-4",
                             "-6:8", "-3÷4", "-1/2-1/4", "-3·(1/4)", "−3×1/4", "-12*20/(8*40)", "+(-0.750)",
                             "1/4-1", "-0.75000000000000000000000000000000000000"}) {
      QCOMPARE(read(text), QString("-3/4"));
    }
  }

  void wholeNumbersAndSums() {
    QCOMPARE(read("007"), QString("7"));
    QCOMPARE(read("2+3*4"), QString("14"));
    QCOMPARE(read("(2+3)*4"), QString("20"));
    QCOMPARE(read("--5"), QString("5"));
    QCOMPARE(read("18/36*20/30"), QString("1/3"));
    QCOMPARE(read("123456789012345678901234567890"), QString("123456789012345678901234567890"));
    QCOMPARE(read("0"), QString("0"));
    QCOMPARE(read("-0"), QString("0"));
  }

  void commasAreDecimalsWhereTheyMustBe() {
    QCOMPARE(read("1,5"), QString("3/2"));
    QCOMPARE(read("0,125"), QString("1/8"));
    QCOMPARE(read("1,2500"), QString("5/4"));
    QCOMPARE(read("1234,125"), QString("9873/8"));
    QCOMPARE(read("1.250"), QString("5/4"));
    for (const char* text : {"1,250", "-12,000", "1.234,5", "1,234.5", "1.2.3"})
      QCOMPARE(read(text), QString("ambiguous"));
  }

  void otherTextsAreNoNumbers() {
    for (const char* text : {"", " ", "x", "1/0", "1/(2-2)", "1 2", "1 1/2", "3+", "(3", "3)", "1e100", ".",
                             ",", "1.", "--", "²", "0x10", "inf", "nan"})
      QCOMPARE(read(text), QString("no number"));
    QCOMPARE(read(std::string(300, '1').c_str()), QString("no number"));
    QCOMPARE(read((std::string(60, '(') + "1" + std::string(60, ')')).c_str()), QString("no number"));
    QCOMPARE(read((std::string(150, '-') + "1").c_str()), QString("no number"));
  }

  /// Of three digits or more, rounded or cut off; never a whole unit of the last place away.
  void decimalsMayBeRounded() {
    QVERIFY(agrees("0.333", Rational(1, 3)));
    QVERIFY(agrees("0,3333", Rational(1, 3)));
    QVERIFY(agrees("0.667", Rational(2, 3)));
    QVERIFY(agrees("0.666", Rational(2, 3)));
    QVERIFY(agrees("-1.33", Rational(-4, 3)));
    QVERIFY(!agrees("0.33", Rational(1, 3)));
    QVERIFY(!agrees("0.335", Rational(1, 3)));
    QVERIFY(!agrees("0.501", Rational(1, 2)));
    QVERIFY(!agrees("0.668", Rational(2, 3)));
    QVERIFY(!agrees("1.33", Rational(-4, 3)));
    QVERIFY(!agrees("333/1000", Rational(1, 3)));
    QVERIFY(agrees("0.333+0", Rational(1, 3)));
    QVERIFY(agrees("-0.333*2", Rational(-2, 3)));
    QVERIFY(agrees("-2.6666666666666665", Rational(-8, 3)));
    QVERIFY(!agrees("-2.664", Rational(-8, 3)));
    QVERIFY(agrees("-0.5", Rational(-1, 2)));
  }
};

}  // namespace geargraph

QTEST_APPLESS_MAIN(geargraph::NumberTextTest)
#include "test_number_text.moc"
