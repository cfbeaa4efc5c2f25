#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/cli/cli_run.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/json_schema.h"

namespace geargraph {

using test::Run;
using test::run;

/// `geargraph-cli lesson`, as the author of a lesson would use it.
class CliLessonTest : public QObject {
  Q_OBJECT

  QTemporaryDir m_folder;
  const QString kLesson = QString::fromStdString(test::sourcePath("resources/lessons/05-cycle-basis.json"));

  /// A copy of the lesson with one text in place of another.
  [[nodiscard]] QString changed(const QByteArray& from, const QByteArray& to) const {
    QFile source(kLesson);
    if (!source.open(QIODevice::ReadOnly)) qFatal("no lesson");
    QByteArray text = source.readAll();
    if (!text.contains(from)) qFatal("nothing to change");
    QFile copy(m_folder.filePath("mine.json"));
    if (!copy.open(QIODevice::WriteOnly)) qFatal("no copy");
    copy.write(text.replace(from, to));
    return copy.fileName();
  }

 private slots:
  void aGoodLessonHasNoFaults() {
    const Run checked = run({"lesson", "check", kLesson, kLesson});
    QCOMPARE(checked.status, 0);
    QCOMPARE(QString::fromStdString(checked.output).count(": 5 steps, no faults\n"), 2);
  }

  void faultsHaveTheirPlace() {
    const QString file = changed("\"about\": \"gearMeshes/17\"", "\"about\": \"gearMeshes/99\"");
    const Run checked = run({"lesson", "check", file});
    QCOMPARE(checked.status, 1);
    const QString output = QString::fromStdString(checked.output);
    QVERIFY2(output.startsWith(file + ':'), qPrintable(output));
    QVERIFY2(output.contains(
                 "error: /steps/2/task/about: No exercise of this kind is about this element. [schema]"),
             qPrintable(output));
    const Run json = run({"lesson", "check", file, "--json"});
    QCOMPARE(json.status, 1);
    const auto parsed = nlohmann::json::parse(json.output);
    std::ifstream results(test::sourcePath("resources/schema/results.schema.json"));
    QCOMPARE(test::JsonSchema(nlohmann::json::parse(results)).complaint(parsed), std::string());
    QCOMPARE(parsed["format"].get<std::string>(), std::string("geargraph-lesson-check"));
    const auto& diagnostic = parsed["lessons"][0]["diagnostics"][0];
    QVERIFY(diagnostic["line"].get<int>() > 30);
    QCOMPARE(diagnostic["pointer"].get<std::string>(), std::string("/steps/2/task/about"));
  }

  void slipsOfThePenAreFound() {
    const Run checked = run({"lesson", "check", changed("\"hints\"", "\"hint\"")});
    QCOMPARE(checked.status, 1);
    QVERIFY2(checked.output.find("The member \"hint\" is not known here.") != std::string::npos,
             checked.output.c_str());
  }

  void theCourseIsListed() {
    const Run listed = run({"lesson", "list"});
    QCOMPARE(listed.status, 0);
    const QStringList lines = QString::fromStdString(listed.output).split('\n', Qt::SkipEmptyParts);
    QVERIFY(lines.size() > 12);
    QVERIFY(lines.first().startsWith("gear-pair "));
    QCOMPARE(lines.last().section(' ', 0, 0).toInt(), static_cast<int>(lines.size()) - 1);
  }

  void wrongUsageIsReported() {
    QCOMPARE(run({"lesson"}).status, 2);
    QCOMPARE(run({"lesson", "check"}).status, 2);
    QCOMPARE(run({"lesson", "list", "x"}).status, 2);
    QCOMPARE(run({"lesson", "check", m_folder.filePath("none.json")}).status, 2);
  }
};

}  // namespace geargraph

QTEST_GUILESS_MAIN(geargraph::CliLessonTest)
#include "test_cli_lesson.moc"
