#include <QTest>
#include <nlohmann/json.hpp>
#include <optional>

#include "core/foundations/files/file.h"
#include "core/teaching/exercises/exercise_sheet.h"
#include "core/teaching/grading/grade.h"
#include "core/teaching/grading/mistake_names.h"
#include "core/teaching/grading/question_json.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/json_schema.h"
#include "tests/fuzz/mutations.h"

namespace geargraph {

using Json = nlohmann::json;

/// resources/schema/exercises.schema.json against what the program writes and what its reader rejects.
class ExerciseSchemaTest : public QObject {
  Q_OBJECT

  std::optional<test::JsonSchema> m_schema;

  /// "" where the document fits.
  [[nodiscard]] std::string complaint(const Json& document) const { return m_schema->complaint(document); }

 private slots:
  void initTestCase() {
    const auto bytes = readFile(test::sourcePath("resources/schema/exercises.schema.json"), 1'000'000);
    m_schema.emplace(Json::parse(std::get<std::string>(bytes)));
  }

  void whatTheProgramWritesFits() {
    int questions = 0;
    for (const std::string& name : test::exampleNames()) {
      const Mechanism mechanism = test::example(name);
      if (mechanism.n() > kMaxExerciseLinks) continue;
      const ExerciseSource source(mechanism);
      const SheetPlan plan{"S", offeredKinds(source), 18446744073709551615U, 3};
      const SheetVariant sheet = makeVariant(source, plan, 2);
      questions += static_cast<int>(sheet.questions.size());
      for (const QuestionPart part : {QuestionPart::withKey, QuestionPart::withoutKey})
        QCOMPARE(complaint(Json::parse(questionsJson(sheet.questions, part))), std::string());
      QCOMPARE(complaint(Json::parse(sheetJson({plan, mechanism}))), std::string());
    }
    QVERIFY(questions > 200);
    QCOMPARE(complaint(
                 Json::parse(answersJson({"0123456789abcdef", 7, "Ada", {{1, {{"C16,8", "1"}}}, {12, {}}}}))),
             std::string());
  }

  void everyMistakeIsOnThePage() {
    const auto page = readFile(test::sourcePath("resources/schema/README.md"), 1'000'000);
    const std::string& text = std::get<std::string>(page);
    for (const MistakeName& mistake : mistakeNames()) {
      const std::string row =
          "| `" + std::string(mistake.name) + "` | " + std::string(mistake.title) + " |\n";
      QVERIFY2(text.find(row) != std::string::npos, row.c_str());
    }
    for (int test = 0; test <= static_cast<int>(Test::outside); ++test) {
      const std::string name = '`' + std::string(testName(static_cast<Test>(test))) + '`';
      QVERIFY2(text.find(name) != std::string::npos, name.c_str());
    }
  }

  void whatTheReaderRejectsIsRejected() {
    const ExerciseSource source(test::example("robot"));
    const SheetPlan plan{"S", {ExerciseKind::cycle, ExerciseKind::teeth}, 5, 1};
    const Json questions =
        Json::parse(questionsJson(makeVariant(source, plan, 1).questions, QuestionPart::withKey));
    int tried = 0;
    const auto rejects = [&](const char* pointer, const Json& value) {
      Json broken = questions;
      broken[Json::json_pointer(pointer)] = value;
      ++tried;
      QVERIFY2(!complaint(broken).empty(), pointer);
      QVERIFY2(!readQuestions(broken.dump()).has_value(), pointer);
    };
    rejects("/format", "geargraph");
    rejects("/version", 2);
    rejects("/questions", Json::object());
    rejects("/questions/0/points", "2");
    rejects("/questions/0/fields", Json::array());
    rejects("/questions/0/fields/0/kind", "word");
    rejects("/questions/0/fields/0/options", Json::array({1}));
    rejects("/questions/0/elements", Json::array({"gears/15"}));
    rejects("/questions/0/accepted", Json::array());
    rejects("/questions/0/accepted/0/test", "equals");
    rejects("/questions/0/accepted/0/values", Json::array());
    rejects("/questions/0/mistakes/0/when", Json::array());
    rejects("/questions/0/mistakes/0/reason", 5);
    rejects("/questions/0/rule", 5);
    QCOMPARE(tried, 14);
    const Json answers = {{"format", "geargraph-answers"}, {"version", 1}, {"sheet", "s"}, {"variant", 1}};
    for (const Json& given : {Json::array(), Json{{"0", Json::object()}}, Json{{"x", Json::object()}},
                              Json{{"1", "a"}}, Json{{"1", {{"r", Json::array()}}}}}) {
      Json broken = answers;
      broken["answers"] = given;
      QVERIFY2(!complaint(broken).empty(), given.dump().c_str());
      QVERIFY2(!readAnswers(broken.dump()).has_value(), given.dump().c_str());
    }
  }

  /// Seeded mutations: the reader takes only what can be graded, and what fits the schema.
  void whatTheReaderAcceptsCanBeGraded() {
    const ExerciseSource source(test::example("simpson"));
    const SheetVariant sheet = makeVariant(source, {"S", offeredKinds(source), 9, 1}, 1);
    test::Random random(20261123);
    int accepted = 0;
    for (int round = 0; round < 6'000; ++round) {
      const Question& question = sheet.questions[static_cast<std::size_t>(round) % sheet.questions.size()];
      std::string text = questionsJson({question}, QuestionPart::withKey);
      test::mutate(text, random);
      const auto read = readQuestions(text);
      if (!read) continue;
      ++accepted;
      for (const Question& one : *read) {
        QVERIFY(!grade(one, std::vector<std::string>(one.fields.size(), "1")).reason.empty() ||
                one.rule.empty());
        static_cast<void>(grade(one, one.solution));
      }
    }
    QVERIFY2(accepted > 500, qPrintable(QString::number(accepted)));
  }
};

}  // namespace geargraph

QTEST_APPLESS_MAIN(geargraph::ExerciseSchemaTest)
#include "test_exercise_schema.moc"
