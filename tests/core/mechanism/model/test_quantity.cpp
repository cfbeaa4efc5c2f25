#include <QTest>
#include <numbers>

#include "core/mechanism/model/quantity.h"

using namespace geargraph;

/// Numbers with the units that people type them in.
class QuantityTest : public QObject {
  Q_OBJECT

 private slots:
  void spellingsOfOneValueAreRead_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<int>("quantity");
    QTest::addColumn<QString>("expected");  // empty: rejected
    const auto row = [](const char* text, Quantity quantity, const char* expected) {
      QTest::addRow("%s as %d", text, static_cast<int>(quantity))
          << text << static_cast<int>(quantity) << expected;
    };
    row("22/7", Quantity::number, "22/7");
    row("2*3", Quantity::number, "6");
    row("1/3+1/5", Quantity::number, "8/15");
    row("3 Nm", Quantity::number, "");

    row("30", Quantity::angle, "30");
    row("30deg", Quantity::angle, "30");
    row("2*15 \xC2\xB0", Quantity::angle, "30");
    row("1/12 turns", Quantity::angle, "30");
    row("10 turns", Quantity::angle, "3600");
    row("1turn", Quantity::angle, "360");
    row("1/2 rev", Quantity::angle, "180");
    row("0.017453292519943295rad", Quantity::angle, "1");
    row("30 rpm", Quantity::angle, "");

    row("1/2", Quantity::speed, "1/2");
    row("2*3 rad/s", Quantity::speed, "6");
    row("30 rad/min", Quantity::speed, "1/2");
    row("180 deg/s", Quantity::speed, "3.1415926535897931");
    row("180\xC2\xB0/s", Quantity::speed, "3.1415926535897931");
    row("1rpm", Quantity::speed, "0.10471975511965977");
    row("1 1/min", Quantity::speed, "0.10471975511965977");
    row("1/min", Quantity::speed, "0.10471975511965977");
    row("1 min-1", Quantity::speed, "0.10471975511965977");
    row("1 min^-1", Quantity::speed, "0.10471975511965977");
    row("1 rev/min", Quantity::speed, "0.10471975511965977");
    row("1 turns/min", Quantity::speed, "0.10471975511965977");
    row("1 U/min", Quantity::speed, "0.10471975511965977");
    row("6 deg/s", Quantity::speed, "0.10471975511965977");
    row("360 deg/min", Quantity::speed, "0.10471975511965977");
    row("1/60 turns/s", Quantity::speed, "0.10471975511965977");
    row("1/60 rps", Quantity::speed, "0.10471975511965977");
    row("3*500 rpm", Quantity::speed, "157.079632679489655");
    row("fast", Quantity::speed, "");
    row("30 deg", Quantity::speed, "");
    row("rpm", Quantity::speed, "");

    row("10", Quantity::torque, "10");
    row("10Nm", Quantity::torque, "10");
    row("10 N m", Quantity::torque, "10");
    row("10 N\xC2\xB7m", Quantity::torque, "10");
    row("10 N*m", Quantity::torque, "10");
    row("\xE2\x88\x92"
        "1/2kNm",
        Quantity::torque, "-500");
    row("500Nmm", Quantity::torque, "1/2");
    row("500 N mm", Quantity::torque, "1/2");
    row("12 N cm", Quantity::torque, "0.12");
    row("12 mNm", Quantity::torque, "0.012");
    row("1 lbf ft", Quantity::torque, "1.3558179483314004");
    row("1 ft-lbf", Quantity::torque, "1.3558179483314004");
    row("1 lb ft", Quantity::torque, "1.3558179483314004");
    row("12 lbf in", Quantity::torque, "1.3558179483314004");
    row("192 ozf in", Quantity::torque, "1.3558179483314004");
    row("1 kgf m", Quantity::torque, "9.80665");
    row("100 kgf cm", Quantity::torque, "9.80665");
    row("(1+1)*5 N m", Quantity::torque, "10");
    row("1 000 Nm", Quantity::torque, "");
    row("10 N", Quantity::torque, "");
    row("2 kW", Quantity::torque, "");
    row("2 kW @ 0 rpm", Quantity::torque, "");
    row("2 kW @ 1500", Quantity::torque, "");
    row("100 W @ 50 rad/s", Quantity::torque, "2");
    row("0.1kW@50rad/s", Quantity::torque, "2");
    row("-0.1 kW at 50 rad/s", Quantity::torque, "-2");

    row("10", Quantity::force, "10");
    row("10 N", Quantity::force, "10");
    row("2*5kN", Quantity::force, "10000");
    row("1 lbf", Quantity::force, "4.4482216152605");
    row("1 kgf", Quantity::force, "9.80665");
    row("10 Nm", Quantity::force, "");
  }
  void spellingsOfOneValueAreRead() {
    QFETCH(QString, text);
    QFETCH(int, quantity);
    QFETCH(QString, expected);
    const auto number = quantityFromText(text.toStdString(), static_cast<Quantity>(quantity));
    QCOMPARE(number.has_value(), !expected.isEmpty());
    if (number) QCOMPARE(number->exact(), *Rational::fromText(expected.toStdString()));
  }

  void valuesAreThoseOfTheUnits() {
    const auto valueOf = [](const char* text, Quantity quantity) {
      return quantityFromText(text, quantity)->value();
    };
    QCOMPARE(valueOf("1500 rpm", Quantity::speed), 50 * std::numbers::pi);
    QCOMPARE(valueOf("1 rad", Quantity::angle), 180 / std::numbers::pi);
    QVERIFY(std::abs(valueOf("2kW@1500rpm", Quantity::torque) - 2000 / (50 * std::numbers::pi)) < 1e-14);
    QVERIFY(std::abs(valueOf("1 hp @ 5252.1131 rpm", Quantity::torque) - 1.3558179483) < 1e-6);  // 1 lbf ft
  }

  /// What follows exactly from typed speeds stays zero or whole.
  void ratiosOfTypedSpeedsAreExact() {
    const Rational one = quantityFromText("100 rpm", Quantity::speed)->exact();
    QCOMPARE(quantityFromText("300 rpm", Quantity::speed)->exact() / one, Rational(3));
    QCOMPARE(quantityFromText("600 deg/s", Quantity::speed)->exact(), one);
    QCOMPARE(quantityFromText("5/3 turns/s", Quantity::speed)->exact(), one);
  }

  void spellingIsKept() {
    QCOMPARE(typedNumber(" 0.10 ")->text(), std::string("0.10"));
    QCOMPARE(withUnitFromText("22/7 Nm", Quantity::torque)->text(), std::string("22/7"));
    QCOMPARE(withUnitFromText("10 rpm", Quantity::speed)->text(), std::string("1.0471975511965977"));
    QVERIFY(!withUnitFromText("10", Quantity::torque));
    QVERIFY(!typedNumber("10^999"));  // beyond a double
  }

  void anglesHaveUnitsAndKeepTheirTurns() {
    const auto turned = angleFromText("3600deg");
    QCOMPARE(turned->degrees, Rational(3600));
    QCOMPARE(angleFromText("10 turns")->degrees, Rational(3600));
    QCOMPARE(angleFromText("1/2+1/3 rad")->radians, Rational(5, 6));
    QCOMPARE(angleFromText("1e1000deg")->degrees, *Rational::fromText("1e1000"));
    QVERIFY(!angleFromText("30"));
    QVERIFY(!angleFromText("deg"));
    QVERIFY(angleFromText("0")->degrees.isZero());
  }
};

QTEST_GUILESS_MAIN(QuantityTest)
#include "test_quantity.moc"
