#include <QTest>

#include "core/foundations/files/file.h"
#include "core/teaching/lessons/bundled_files.h"
#include "core/teaching/lessons/course.h"
#include "core/teaching/lessons/lesson_checker.h"
#include "core/teaching/lessons/lesson_reader.h"
#include "core/teaching/lessons/quantities.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/json_schema.h"
#include "tests/fuzz/mutations.h"

namespace geargraph {

using Json = nlohmann::json;

/// resources/schema/lesson.schema.json against the lessons of the program and what their reader rejects.
class LessonSchemaTest : public QObject {
  Q_OBJECT

  const test::JsonSchema m_schema{Json::parse(fileText("resources/schema/lesson.schema.json"))};
  const std::vector<std::string> m_texts = [] {
    std::vector<std::string> texts;
    for (const auto& file : lessonFiles()) texts.emplace_back(file.begin(), file.end());
    return texts;
  }();

  static std::string fileText(const std::string& path) {
    return std::get<std::string>(readFile(test::sourcePath(path), 1'000'000));
  }
  [[nodiscard]] Json firstLesson() const { return Json::parse(m_texts.front()); }

 private slots:
  void everyLessonFits() {
    QCOMPARE(m_texts.size(), course().size());
    for (const std::string& text : m_texts) QCOMPARE(m_schema.complaint(Json::parse(text)), std::string());
  }

  void everyQuantityIsInTheSchemaAndOnThePage() {
    const std::string schema = fileText("resources/schema/lesson.schema.json");
    const std::string page = fileText("resources/lessons/README.md");
    for (int i = 0; i <= static_cast<int>(LessonQuantity::leverPlace); ++i) {
      const std::string name(quantityName(static_cast<LessonQuantity>(i)));
      QCOMPARE(quantityFromName(name), std::optional(static_cast<LessonQuantity>(i)));
      QVERIFY2(schema.find('"' + name + '"') != std::string::npos, name.c_str());
      QVERIFY2(page.find('`' + name + '`') != std::string::npos, name.c_str());
    }
  }

  void whatTheReaderRejectsIsRejected_data() {
    QTest::addColumn<QString>("pointer");
    QTest::addColumn<QString>("value");
    const auto row = [](const char* pointer, const char* value) {
      QTest::newRow(qPrintable(QString(pointer) + ' ' + value)) << QString(pointer) << QString(value);
    };
    row("/format", "\"geargraph\"");
    row("/version", "2");
    row("/id", "\"Cycle basis\"");
    row("/title", "\"\"");
    row("/minutes", "0");
    row("/minutes", "\"5\"");
    row("/steps", "[]");
    row("/hints", "[]");
    row("/steps/0/hint", "\"look\"");
    row("/steps/0/hints", "[]");
    row("/steps/0/view", "\"3d\"");
    row("/steps/0/elements", "[\"gears/5\"]");
    row("/steps/0/task/kind", "\"guess\"");
    row("/steps/0/task/fields", "[]");
    row("/steps/0/task/fields/0/kind", "\"word\"");
    row("/steps/0/task/mistakes", "[]");
    row("/steps/0/task/mistakes/0/answers", "5");
    row("/steps/0/task/mistakes/0/when", "[]");
    row("/steps/1/task/fields/0/is/quantity", "\"colour\"");
    row("/steps/2/task/exercise", "5");
    row("/steps/3/task/conditions", "[]");
    row("/steps/3/task/conditions/0/quantity", "\"colour\"");
    row("/steps/3/task/mistakes/0/failing", "-1");
  }
  void whatTheReaderRejectsIsRejected() {
    QFETCH(QString, pointer);
    QFETCH(QString, value);
    Json broken = firstLesson();
    broken[Json::json_pointer(pointer.toStdString())] = Json::parse(value.toStdString());
    QVERIFY(!m_schema.complaint(broken).empty());
    const auto read = readLesson(broken.dump(2));
    QVERIFY(!read.has_value());
    const Diagnostic& fault = read.error().front();
    QVERIFY2(fault.line > 0 && fault.column > 0, fault.message.c_str());
    const std::string place = pointer.toStdString();
    const std::string parent = place.substr(0, place.rfind('/'));
    const bool isThere = fault.pointer.starts_with(parent);
    QVERIFY2(isThere, fault.pointer.c_str());
  }

  /// Seeded mutations of every lesson: what the reader takes can be prepared and checked, or is reported.
  void mutatedLessonsAreReportedOrTaught() {
    test::Random random(20261124);
    int read = 0;
    int faulty = 0;
    for (int round = 0; round < 400; ++round) {
      std::string text = m_texts[static_cast<std::size_t>(round) % m_texts.size()];
      test::mutate(text, random);
      const auto lesson = readLesson(text);
      if (!lesson) continue;
      ++read;
      for (const Diagnostic& diagnostic : placedInText(text, checkLesson(*lesson, bundledExample))) {
        QVERIFY2(diagnostic.line > 0, diagnostic.message.c_str());
        ++faulty;
      }
    }
    QVERIFY2(read > 40 && faulty > 5, qPrintable(QString("%1 %2").arg(read).arg(faulty)));
  }
};

}  // namespace geargraph

QTEST_APPLESS_MAIN(geargraph::LessonSchemaTest)
#include "test_lesson_schema.moc"
