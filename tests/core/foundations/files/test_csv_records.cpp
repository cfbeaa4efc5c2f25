#include <QTest>
#include <random>

#include "core/foundations/files/csv_records.h"

using namespace geargraph;

namespace {

/// All fields, "|" between them, "/" between records, then the error: "a|b/c; 2:5".
QString all(const std::string& text, char separator = ',') {
  CsvRecords records(text, separator);
  std::vector<CsvField> fields;
  QString result;
  while (records.next(fields)) {
    if (!result.isEmpty()) result += '/';
    for (std::size_t i = 0; i < fields.size(); ++i)
      result += (i > 0 ? "|" : "") + QString::fromStdString(fields[i].text);
  }
  if (records.error()) result += QString("; %1:%2").arg(records.error()->line).arg(records.error()->column);
  return result;
}

}  // namespace

class CsvRecordsTest : public QObject {
  Q_OBJECT

 private slots:
  void fieldsAndRecords_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("fields");
    QTest::newRow("nothing") << QByteArray() << "";
    QTest::newRow("one row") << QByteArray("a,b,c") << "a|b|c";
    QTest::newRow("line ends") << QByteArray("a\nb\r\nc\rd\n") << "a/b/c/d";
    QTest::newRow("empty lines and fields") << QByteArray("\n\na,\n\n,b\n") << "a|/|b";
    QTest::newRow("quotes") << QByteArray("\"a,b\",\"c\"\"d\",\"\"") << "a,b|c\"d|";
    QTest::newRow("line end in quotes") << QByteArray("\"a\r\nb\",c\nd") << "a\r\nb|c/d";
    QTest::newRow("blanks") << QByteArray(" a b ,\t\" c \"\t,d\t") << "a b| c |d";
    QTest::newRow("byte order mark") << QByteArray("\xEF\xBB\xBF\"a\",b") << "a|b";
    QTest::newRow("quote in a field") << QByteArray("a,b\nc,d\"e") << "a|b; 2:4";
    QTest::newRow("behind a quote") << QByteArray("\"a\" b") << "; 1:5";
    QTest::newRow("open quote") << QByteArray("a\n Γ, \"b\nc") << "a; 2:5";
    QTest::newRow("no UTF-8") << QByteArray("Γ,\xC0\x80") << "; 1:3";
  }
  void fieldsAndRecords() {
    QFETCH(QByteArray, text);
    QTEST(all(text.toStdString()), "fields");
  }

  void placesAreLinesAndCharacters() {
    CsvRecords records("a,\"x\ny\"\nΓΓ, b,\n", ',');
    std::vector<CsvField> fields;
    QVERIFY(records.next(fields));
    QVERIFY(records.next(fields));
    QCOMPARE(fields.size(), std::size_t{3});
    QCOMPARE(std::pair(fields[1].line, fields[1].column), std::pair(3, 5));
    const CsvRecords::Place second = records.place();
    QVERIFY(!records.next(fields));
    records.moveTo(second);
    QVERIFY(records.next(fields));
    QCOMPARE(fields[0].text, std::string("ΓΓ"));
  }

  void aLongRecordIsCountedAndNotStored() {
    const std::string row(1'000'000, ',');
    CsvRecords records(row, ',');
    std::vector<CsvField> fields;
    QVERIFY(records.next(fields));
    QCOMPARE(records.count(), std::size_t{1'000'001});
    QCOMPARE(fields.size(), CsvRecords::kMaxFields);
  }

  void theSeparatorIsTheMostFrequentOfTheFirstLine() {
    QCOMPARE(csvSeparatorOf("a,b;c\n;;;;"), ',');
    QCOMPARE(csvSeparatorOf("\n\na;b,c;d"), ';');
    QCOMPARE(csvSeparatorOf("a\tb"), '\t');
    QCOMPARE(csvSeparatorOf("\"a;b;c\",d"), ',');
    QCOMPARE(csvSeparatorOf(""), ',');
  }

  void everyTextIsReadBack() {
    std::mt19937 random(7);
    const std::string letters = "a\",;\t \r\n'=";
    for (int round = 0; round < 20'000; ++round) {
      std::string text;
      for (unsigned i = random() % 6; i > 0; --i) text += letters[random() % letters.size()];
      const char separator = ",;\t"[random() % 3];
      const std::string row = "x" + std::string(1, separator) + csvField(text, separator) + '\n';
      CsvRecords records(row, separator);
      std::vector<CsvField> fields;
      QVERIFY2(records.next(fields), row.c_str());
      QCOMPARE(fields.size(), std::size_t{2});
      QCOMPARE(fields[1].text, text);
      QVERIFY(!records.next(fields));
    }
  }
};

QTEST_APPLESS_MAIN(CsvRecordsTest)
#include "test_csv_records.moc"
