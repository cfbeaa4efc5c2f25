#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "tests/cli/cli_run.h"

namespace {

struct Summary {
  int status = -1;
  QStringList lines;
};

Summary summaryOf(const QStringList& words) {
  const auto call = geargraph::test::run(QStringList{"summary"} + words);
  return {call.status, QString::fromStdString(call.output).split('\n', Qt::SkipEmptyParts)};
}

QString examples() {
  return QString(SOURCE) + "/resources/examples";
}

}  // namespace

class SummaryTest : public QObject {
  Q_OBJECT

 private slots:
  void aFolderIsARowForEachDocumentWhateverTheJobs() {
    const Summary one = summaryOf({"--jobs", "1", examples()});
    const Summary four = summaryOf({"--jobs", "4", examples()});
    QCOMPARE(four.lines, one.lines);
    const auto documents = QDir(examples()).entryList({"*.geargraph"}).size();
    QCOMPARE(one.lines.size(), documents + 1);
    const auto robot = one.lines.filter("/robot.geargraph,");
    QCOMPARE(robot.size(), 1);
    QVERIFY2(robot[0].contains(",ok,7,7,4,4,3,0,0,0,,"), qPrintable(robot[0]));
  }

  void whatIsWrongIsInItsRow() {
    const QTemporaryDir folder;
    QFile broken(folder.filePath("broken.geargraph"));
    QVERIFY(broken.open(QIODevice::WriteOnly));
    broken.write("{");
    broken.close();
    const Summary errors = summaryOf({folder.path(), examples() + "/robot.geargraph"});
    QCOMPARE(errors.status, 1);
    QVERIFY2(errors.lines[1].contains(",errors,,,,,,,1,0,syntax,"), qPrintable(errors.lines[1]));
    QVERIFY(errors.lines[2].contains(",ok,"));
    const Summary none = summaryOf({folder.filePath("none.geargraph")});
    QCOMPARE(none.status, 2);
    QVERIFY(none.lines[1].contains(",unreadable,"));
  }

  void wrongUsage() {
    QCOMPARE(summaryOf({}).status, 2);
    QCOMPARE(summaryOf({"--jobs", "0", examples()}).status, 2);
    QCOMPARE(summaryOf({"--jobs", "many", examples()}).status, 2);
  }

  void theRowsGoIntoAFile() {
    const QTemporaryDir folder;
    const QString path = folder.filePath("rows.csv");
    QCOMPARE(summaryOf({examples() + "/robot.geargraph", "-o", path}).lines.size(), 0);
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    QCOMPARE(file.readAll().count('\n'), 2);
  }
};

QTEST_GUILESS_MAIN(SummaryTest)
#include "test_summary.moc"
