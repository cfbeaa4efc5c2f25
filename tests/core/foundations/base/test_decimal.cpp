#include <QTest>
#include <limits>

#include "core/foundations/base/decimal.h"

using namespace geargraph;

class DecimalTest : public QObject {
  Q_OBJECT

 private slots:
  void aNumberAndNothingElse_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<double>("expected");  // NaN: none
    const double none = std::numeric_limits<double>::quiet_NaN();
    const auto row = [](const char* text, double expected) {
      QTest::newRow(*text == '\0' ? "empty" : text) << QByteArray(text) << expected;
    };
    row("0", 0);
    row("-1.5", -1.5);
    row("0.1", 0.1);
    row("1e-3", 1e-3);
    row("1.7976931348623157e308", std::numeric_limits<double>::max());
    row("1.7976931348623159e308", none);
    row("1e999", none);
    row("", none);
    row("-", none);
    row("+1", none);
    row(" 1", none);
    row("1 ", none);
    row("1,5", none);
    row("1.5.2", none);
    row("0x10", none);
    row("ten", none);
  }
  void aNumberAndNothingElse() {
    QFETCH(QByteArray, text);
    QFETCH(double, expected);
    const auto number =
        decimalFrom(std::string_view(text.constData(), static_cast<std::size_t>(text.size())));
    QCOMPARE(number.has_value(), !std::isnan(expected));
    if (number) QVERIFY(*number == expected);  // to the last bit
  }
};

QTEST_APPLESS_MAIN(DecimalTest)
#include "test_decimal.moc"
