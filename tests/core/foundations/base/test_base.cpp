#include <QTest>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <limits>
#include <random>
#include <set>

#include "core/foundations/base/diagnostic.h"
#include "core/foundations/base/id.h"
#include "core/foundations/base/rational.h"

namespace geargraph {

class BaseTest : public QObject {
  Q_OBJECT

 private slots:
  void rationalReadsWhatPeopleWrite_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("exact");
    const std::pair<const char*, const char*> cases[] = {
        {"3", "3"},           {"-22/7", "-22/7"},
        {"4/6", "2/3"},       {"0.125", "1/8"},
        {"1.5e-3", "3/2000"}, {"1e3", "1000"},
        {"-0.0", "0"},        {"+7", "7"},
        {".5", "1/2"},        {"1E+2", "100"},
        {"0/5", "0"},         {"123456789012345678901234567890/3", "41152263004115226300411522630"},
    };
    for (const auto& [text, exact] : cases) QTest::newRow(text) << QString(text) << QString(exact);
  }
  void rationalReadsWhatPeopleWrite() {
    QFETCH(QString, text);
    QFETCH(QString, exact);
    const auto value = Rational::fromText(text.toStdString());
    QVERIFY(value.has_value());
    QCOMPARE(QString::fromStdString(value->toString()), exact);
  }

  void rationalRejectsWhatIsNoNumber_data() {
    QTest::addColumn<QString>("text");
    for (const char* text : {"", "-", "1/0", "1/-2", "a", "1.", "1/2/3", "1e", "1e9999999", "0x10", " 1",
                             "1 ", "1/", "/2", "nan", "inf", "1.5/2", "--1", "1e+-2"}) {
      QTest::newRow(text) << QString(text);
    }
  }
  void rationalRejectsWhatIsNoNumber() {
    QFETCH(QString, text);
    QVERIFY(!Rational::fromText(text.toStdString()).has_value());
  }

  void longNumbersAreRejectedNotComputed() {
    QVERIFY(!Rational::fromText(std::string(5000, '9')).has_value());
    QVERIFY(!Rational::fromText("1e5000").has_value());
    QVERIFY(Rational::fromText("1e4000").has_value());
  }

  void doublesAreExactBothWays() {
    for (const double value : {0.1, -1.0 / 3, 1e300, 5e-324, 0.0, 123456.789}) {
      QCOMPARE(Rational::fromDouble(value).toDouble(), value);
    }
    QCOMPARE(QString::fromStdString(Rational::fromDouble(0.75).toString()), QStringLiteral("3/4"));
  }

  /// The shortest decimal of a double lies anywhere in its rounding interval: only the nearest double reads
  /// it back.
  void toDoubleIsTheNearestDouble() {
    std::mt19937_64 random(3);
    int finite = 0;
    for (int i = 0; i < 20'000; ++i) {
      const auto value =
          std::bit_cast<double>(i % 4 == 0 ? random() >> 12U : random());  // every fourth subnormal
      if (!std::isfinite(value)) continue;
      ++finite;
      std::array<char, 32> text{};
      const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
      const auto exact = Rational::fromText({text.data(), static_cast<std::size_t>(end - text.data())});
      QVERIFY2(exact && exact->toDouble() == value, text.data());
    }
    QVERIFY(finite > 19'000);
    QCOMPARE(Rational::fromText("9007199254740993").value().toDouble(),
             9007199254740992.0);  // a tie, to even
    QCOMPARE(Rational::fromText("9007199254740993.1").value().toDouble(), 9007199254740994.0);
    QVERIFY(std::isinf(Rational::fromText("-1e400").value().toDouble()));
    QCOMPARE(Rational::fromText("1e-400").value().toDouble(), 0.0);
  }

  void rationalArithmeticIsThatOfFractions() {
    const Rational a(1, 3);
    const Rational b(-1, 6);
    QVERIFY(a + b == Rational(1, 6));
    QVERIFY(a * b == Rational(-1, 18));
    QVERIFY(a / b == Rational(-2));
    QVERIFY(b < a);
    QVERIFY((a - a).isZero());
    QVERIFY(Rational(4, 9).squareRoot() == Rational(2, 3));
    QVERIFY(!Rational(2).squareRoot().has_value());
    QVERIFY(!Rational(-4).squareRoot().has_value());
  }

  void equalTextsAreTheSameAtom() {
    const std::string built = std::string("wh") + "eel";
    QVERIFY(InternedString("wheel") == InternedString(built));
    QCOMPARE(&InternedString("wheel").text(), &InternedString(built).text());
    QVERIFY(InternedString("a") < InternedString("b"));
    QVERIFY(InternedString().empty());
    QVERIFY(InternedString("") == InternedString());
  }

  void elementsOfDifferentListsDiffer() {
    QVERIFY(ElementId(JointId("8")) != ElementId(MeshId("8")));
    QVERIFY(ElementId(JointId("8")) == ElementId(JointId("8")));
  }

  void codesHaveDistinctNames() {
    std::set<std::string_view> names;
    for (const Code code : allCodes()) names.insert(codeName(code));
    QCOMPARE(names.size(), allCodes().size());
    QCOMPARE(codeName(Code::noTransferVertex), std::string_view("no-transfer-vertex"));
  }

  /// Sub-codes are as stable as codes: scripts match on them.
  void detailsAreNamedBehindTheirCodes() {
    std::set<std::string_view> names;
    for (const Detail detail : allDetails()) {
      const std::string code(codeName(codeOf(detail)));
      QVERIFY(detailName(detail).starts_with(code + "/"));
      QVERIFY(detailName(detail).size() > code.size() + 1);
      names.insert(detailName(detail));
    }
    QCOMPARE(names.size(), allDetails().size());
    QCOMPARE(detailName(Detail::bodiesOverlap), std::string_view("interference/bodies-overlap"));
    QCOMPARE(detailName(Detail::none), std::string_view());
    QCOMPARE(severityOf(Code::redundantMesh), Severity::warning);
    QCOMPARE(severityOf(Code::idleJoint), Severity::info);
  }

  void aDetailMayBeANote() {
    for (const Detail detail : allDetails()) {
      const bool isNote = detail == Detail::equalPlanets;
      QCOMPARE(severityOf(detail), isNote ? Severity::info : severityOf(codeOf(detail)));
    }
    Diagnostics all(3);
    all[0].code = Code::redundantMesh;
    all[0].detail = Detail::equalPlanets;
    all[1].code = Code::assembly;
    all[2].code = Code::schema;
    sortBySeverity(all);
    QCOMPARE(all[0].code, Code::schema);
    QCOMPARE(all[1].code, Code::assembly);
    QCOMPARE(all[2].severity(), Severity::info);
  }
};

}  // namespace geargraph

QTEST_APPLESS_MAIN(geargraph::BaseTest)
#include "test_base.moc"
