#include <QTest>

#include "tests/cli/cli_run.h"
#include "tests/core/support/example_files.h"

using namespace geargraph::test;

class ConvertTest : public QObject {
  Q_OBJECT

 private slots:
  void anExampleHasTheSameResultsBehindItsTable_data() {
    QTest::addColumn<QString>("name");
    for (const std::string& name : exampleNames())
      QTest::newRow(name.c_str()) << QString::fromStdString(name);
  }
  void anExampleHasTheSameResultsBehindItsTable() {
    QFETCH(QString, name);
    QTemporaryDir folder;
    const QString file = QString::fromStdString(examplePath(name.toStdString()));
    const QString table = folder.filePath("table.csv");
    const QString back = folder.filePath("back.geargraph");
    const Run there = run({"convert", file, "--to", "csv", "-o", table});
    QCOMPARE(there.status, 0);
    QCOMPARE(there.output, std::string());
    QVERIFY2(there.errors.find("Not in the table: the view") != std::string::npos, there.errors.c_str());
    const Run again = run({"convert", table, "--to", "geargraph", "-o", back});
    QCOMPARE(again.status, 0);
    QCOMPARE(again.errors, std::string());
    for (const char* const command : {"analyze", "statics", "states"}) {
      const Run before = run({command, file, "--json"});
      const Run after = run({command, back, "--json"});
      QVERIFY2(after.output == before.output, command);
      QCOMPARE(after.status, before.status);
    }
  }

  void anExampleHasTheSameResultsBehindItsGraph_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("form");
    for (const std::string& name : exampleNames()) {
      for (const char* const form : {"dot", "graphml", "node-link"})
        QTest::addRow("%s %s", name.c_str(), form) << QString::fromStdString(name) << form;
    }
  }
  void anExampleHasTheSameResultsBehindItsGraph() {
    QFETCH(QString, name);
    QFETCH(QString, form);
    QTemporaryDir folder;
    const QString file = QString::fromStdString(examplePath(name.toStdString()));
    const QString graph = folder.filePath("graph");
    const QString back = folder.filePath("back.geargraph");
    const Run there = run({"convert", file, "--to", form, "-o", graph});
    QCOMPARE(there.status, 0);
    QVERIFY2(there.errors.find("Not in the graph: the view") != std::string::npos, there.errors.c_str());
    const Run again = run({"convert", graph, "--to", "geargraph", "-o", back});
    QCOMPARE(again.status, 0);
    QCOMPARE(again.errors, std::string());
    for (const char* const command : {"analyze", "statics", "states"}) {
      const Run before = run({command, file, "--json"});
      const Run after = run({command, back, "--json"});
      QVERIFY2(after.output == before.output, command);
      QCOMPARE(after.status, before.status);
    }
  }

  void oneGraphBecomesAnother() {
    const QByteArray robot = QByteArray::fromStdString(exampleText("robot"));
    QByteArray text = robot;
    for (const char* const form : {"dot", "node-link", "graphml", "csv", "dot"})
      text = QByteArray::fromStdString(run({"convert", "-", "--to", form}, text).output);
    QCOMPARE(text.toStdString(), run({"convert", "-", "--to", "dot"}, robot).output);
    QVERIFY(text.contains("digraph \"Geared robotic mechanism\""));
  }

  void aFileThatIsThereIsReplacedOnlyByAWholeOne() {
    QTemporaryDir folder;
    const QString place = folder.filePath("kept.geargraph");
    QFile file(place);
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write("kept") == 4);
    file.close();
    QCOMPARE(run({"convert", "-", "--to", "geargraph", "-o", place}, "element,id\nlink,\"0").status, 1);
    QVERIFY(file.open(QIODevice::ReadOnly));
    QCOMPARE(file.readAll(), QByteArray("kept"));
  }
};

QTEST_GUILESS_MAIN(ConvertTest)
#include "test_convert.moc"
