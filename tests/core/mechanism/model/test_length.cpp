#include <QTest>

#include "core/mechanism/model/length.h"

namespace geargraph {

class LengthTest : public QObject {
  Q_OBJECT

 private slots:
  void whatIsTypedIsConvertedExactly_data() {
    QTest::addColumn<QByteArray>("typed");
    QTest::addColumn<QByteArray>("unit");
    QTest::addColumn<QByteArray>("expected");  // nothing where it is no such length
    const auto row = [](const char* typed, const char* unit, const char* expected) {
      QTest::addRow("%s in %s", typed, unit) << QByteArray(typed) << QByteArray(unit) << QByteArray(expected);
    };
    row("12", "mm", "12");
    row(" 22/7 ", "mm", "22/7");
    row("1 in", "mm", "25.4");
    row("1/2\"", "mm", "12.7");
    row("1'", "in", "12");
    row("7 mm", "in", "35/127");
    row("2.5cm", "mm", "25");
    row("-3 mil", "mm", "-0.0762");
    row("5 µm", "mm", "0.005");
    row("1e-3 m", "mm", "1");
    row("4 furlong", "furlong", "4");
    row("4 furlong", "mm", "");
    row("4 mm", "furlong", "");
    row("mm", "mm", "");
    row("1 in in", "mm", "");
    row("2*3", "mm", "6");
    row("(1+1/2) in", "mm", "38.1");
    row("100/22", "mm", "50/11");
    row("", "mm", "");
  }
  void whatIsTypedIsConvertedExactly() {
    QFETCH(QByteArray, typed);
    QFETCH(QByteArray, unit);
    QFETCH(QByteArray, expected);
    const auto length = lengthFromText(typed.toStdString(), unit.toStdString());
    QCOMPARE(length.has_value(), !expected.isEmpty());
    if (length) QCOMPARE(length->exact(), Number::fromText(expected.toStdString())->exact());
  }
};

}  // namespace geargraph

QTEST_APPLESS_MAIN(geargraph::LengthTest)
#include "test_length.moc"
