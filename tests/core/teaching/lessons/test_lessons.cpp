#include <QRegularExpression>
#include <QTest>
#include <algorithm>
#include <set>

#include "core/teaching/lessons/course.h"
#include "core/teaching/lessons/lesson_checker.h"
#include "core/teaching/lessons/lesson_reader.h"
#include "core/teaching/lessons/quantities.h"
#include "tests/core/support/example_files.h"

namespace geargraph {

/// A learner works on every lesson of the program: a right and a wrong answer to each task.
class LessonsTest : public QObject {
  Q_OBJECT

  static PreparedStep prepared(const Lesson& lesson, std::size_t step) {
    auto result = prepareStep(lesson, step, bundledExample);
    if (!result) qFatal("%s: %s", lesson.id.c_str(), result.error().front().message.c_str());
    return std::move(result).value();
  }
  static Rational number(const Mechanism& mechanism, LessonQuantity quantity, const std::string& of = {}) {
    LessonAnalysis analysis(std::make_shared<const Mechanism>(mechanism));
    return analysis.valuesOf({quantity, of}).value().numbers.at(0);
  }
  /// `text` with apostrophes for quotation marks.
  static std::string reasonAgainst(std::string text) {
    std::replace(text.begin(), text.end(), '\'', '"');
    const auto lesson = readLesson(text);
    const Diagnostics diagnostics =
        lesson ? placedInText(text, checkLesson(*lesson, bundledExample)) : lesson.error();
    return diagnostics.empty() ? std::string() : diagnostics.front().message;
  }
  /// A lesson of one step about the spur pair.
  static std::string lessonWith(const std::string& task, const std::string& more = {}) {
    return std::string(
               "{'format': 'geargraph-lesson', 'version': 1, 'id': 'one', 'title': 'One', 'minutes': 5, "
               "'goal': 'do it', 'example': 'spur-pair', ") +
           more +
           "'steps': [{'title': 'S', 'text': 'T', 'hints': ['H'], "
           "'task': " +
           task + "}]}";
  }

 private slots:
  void everyLessonCanBeTaught() {
    std::set<std::string> ids;
    for (const Lesson& lesson : course()) {
      for (const Diagnostic& diagnostic : checkLesson(lesson, bundledExample))
        QFAIL(qPrintable(QString::fromStdString(lesson.id + diagnostic.pointer + ": " + diagnostic.message)));
      QVERIFY2(ids.insert(lesson.id).second, lesson.id.c_str());
    }
  }

  /// Every answer but the right one is rejected with a sentence.
  void wrongAnswersGetAReason() {
    int reasons = 0;
    for (const Lesson& lesson : course()) {
      for (std::size_t step = 0; step < lesson.steps.size(); ++step) {
        const PreparedStep ready = prepared(lesson, step);
        if (!ready.question) continue;
        QVERIFY(grade(*ready.question, ready.question->solution).isRight);
        const auto* task = std::get_if<AnswerTask>(&lesson.steps[step].task);
        for (std::size_t i = 0; task != nullptr && i < task->mistakes.size(); ++i) {
          const Verdict verdict = grade(*ready.question, exampleOf(task->mistakes[i], *ready.question));
          QVERIFY(!verdict.isRight);
          QCOMPARE(verdict.reason, task->mistakes[i].mistake.reason);
          ++reasons;
        }
        const Verdict empty = grade(*ready.question, std::vector<std::string>(ready.question->fields.size()));
        QVERIFY2(!empty.isRight && !empty.reason.empty(), lesson.id.c_str());
      }
    }
    QVERIFY(reasons >= static_cast<int>(course().size()));
  }

  /// A hint names no link that is asked for, and not all elements of a set or of a row.
  void hintsDoNotHoldTheAnswer() {
    const auto names = [](const std::string& hint, const std::string& label) {
      const QString pattern =
          "(^|[^\\w/.])" + QRegularExpression::escape(QString::fromStdString(label)) + "([^\\w/]|$)";
      return QString::fromStdString(hint).contains(QRegularExpression(pattern));
    };
    for (const Lesson& lesson : course()) {
      for (std::size_t step = 0; step < lesson.steps.size(); ++step) {
        const PreparedStep ready = prepared(lesson, step);
        if (!ready.question) continue;
        const Question& question = *ready.question;
        std::set<std::string> asked;
        for (std::size_t i = 0; i < question.fields.size(); ++i) {
          const AnswerField& field = question.fields[i];
          if (field.kind == FieldKind::set) {
            for (const std::string& label : readField(field, question.solution[i]).elements)
              asked.insert(label);
          }
          if (question.table.rows.size() == 1 && field.kind == FieldKind::integer &&
              question.solution[i] != "0")
            asked.insert(question.table.columns[i]);
          const bool isLink = field.name == "k" || field.name == "transfer vertex";
          for (const std::string& hint : lesson.steps[step].hints)
            QVERIFY2(!isLink || !names(hint, "link " + question.solution[i]), hint.c_str());
        }
        for (const std::string& hint : lesson.steps[step].hints) {
          const bool namesAll =
              asked.size() > 1 && std::all_of(asked.begin(), asked.end(),
                                              [&](const std::string& label) { return names(hint, label); });
          QVERIFY2(!namesAll, (lesson.id + ": " + hint).c_str());
        }
      }
    }
  }

  void quantitiesAreThoseOfTheAnalysis() {
    const Mechanism robot = test::example("robot");
    QCOMPARE(number(robot, LessonQuantity::links), Rational(7));
    QCOMPARE(number(robot, LessonQuantity::bevelMeshes), Rational(3));
    QCOMPARE(number(robot, LessonQuantity::dof), Rational(3));
    QCOMPARE(number(robot, LessonQuantity::rate, "10"), Rational(-1, 2));
    QCOMPARE(number(test::example("ravigneaux"), LessonQuantity::ratio, "1"), Rational(72, 30));
    LessonAnalysis analysis(std::make_shared<const Mechanism>(robot));
    QCOMPARE(analysis.valuesOf({LessonQuantity::transferVertex, "17"})->elements,
             std::vector<ElementId>{LinkId("2")});
    QCOMPARE(analysis.valuesOf({LessonQuantity::cycle, "16"})->elements,
             (std::vector<ElementId>{JointId("9"), JointId("10"), JointId("12")}));
    LessonAnalysis faulty(std::make_shared<const Mechanism>(test::example("robot-to-mend")));
    QVERIFY(!faulty.valuesOf({LessonQuantity::dof, ""}).has_value());
    const auto blamed = faulty.valuesOf({LessonQuantity::blamed, "turning-loop"})->elements;
    QVERIFY(std::find(blamed.begin(), blamed.end(), ElementId(JointId("19"))) != blamed.end());
    QCOMPARE(faulty.valuesOf({LessonQuantity::rate, "x"}).error().front().code, Code::unknownId);
  }

  /// A torque 10 N m on the driven gear of a pair 20 : 30 needs 20/3 N m at the driver, in the same sense.
  void torquesAreThatHoldTheLoads() {
    Mechanism pair = test::example("spur-pair");
    pair.loads.push_back({LoadId(), JointTorque{JointId("4"), Number(10)}});
    QCOMPARE(number(pair, LessonQuantity::torque, "3"), Rational(20, 3));
  }

  void faultsOfAuthorsAreNamed() {
    const std::string choose =
        "{'kind': 'choose', 'prompt': 'P', 'options': ['a', 'b'], 'accepted': ['a'], "
        "'mistakes': [{'answers': ['";
    QCOMPARE(reasonAgainst(lessonWith(choose + "b'], 'reason': 'R'}], 'rule': 'So.'}")), std::string());
    QCOMPARE(reasonAgainst(lessonWith(choose + "a'], 'reason': 'R'}], 'rule': 'So.'}")),
             std::string("/steps/0/task/mistakes/0: This answer is accepted as right."));
    QCOMPARE(reasonAgainst(lessonWith(choose + "c'], 'reason': 'R'}], 'rule': 'So.'}")),
             std::string("/steps/0/task/mistakes/0: The field \"answer\" cannot hold \"c\"."));
    QCOMPARE(
        reasonAgainst(lessonWith(choose + "b'], 'reason': 'R'}], 'rule': 'So.'}", "'terms': ['Gizmo'],")),
        std::string("/terms/0: The glossary has no term \"Gizmo\"."));
    QCOMPARE(reasonAgainst(lessonWith("{'kind': 'exercise', 'exercise': 'brakes'}")),
             std::string("/steps/0/task/exercise: The document gives no exercise of this kind: no brakes or "
                         "clutches."));
    QCOMPARE(reasonAgainst(lessonWith("{'kind': 'pick', 'prompt': 'P', 'from': ['links'], "
                                      "'is': {'quantity': 'cycle', 'of': '9'}, 'mistakes': [{'answers': "
                                      "['1'], 'reason': 'R'}], 'rule': 'So.'}")),
             std::string("The document has no gear mesh \"9\"."));
    QCOMPARE(reasonAgainst(
                 lessonWith("{'kind': 'type', 'prompt': 'P', 'fields': [{'name': 'n', 'kind': 'integer', "
                            "'is': {'quantity': 'links'}}], 'mistakes': [{'answers': ['3'], 'reason': 'R'}, "
                            "{'answers': ['3'], 'reason': 'S'}], 'rule': 'So.'}")),
             std::string("/steps/0/task/mistakes/1: This answer gets another reason: \"R\""));
    QCOMPARE(
        reasonAgainst(lessonWith(
            "{'kind': 'draw', 'prompt': 'P', "
            "'conditions': [{'quantity': 'links', 'equals': 2, 'reason': 'R'}], 'solution': 'spur-pair', "
            "'mistakes': [{'drawing': 'robot', 'failing': 0}], 'rule': 'So.'}")),
        std::string("/steps/0/task/conditions: The document of the step fulfils them already: nothing is "
                    "left to draw."));
  }

  /// Any drawing that fulfils the conditions is right, and errors are named with their culprits.
  void drawingsAreJudgedByWhatTheyDo() {
    DrawTask task;
    // Member by member: of braces with optional strings, GCC 12 warns that they may not be set.
    const auto add = [&](LessonQuantity quantity, const char* value, const char* reason) {
      DrawingCondition& condition = task.conditions.emplace_back();
      condition.quantity.quantity = quantity;
      condition.least = value;
      condition.most = value;
      condition.reason = reason;
    };
    add(LessonQuantity::errors, "0", "There is an error.");
    add(LessonQuantity::outputRates, "-2/3", "The speed is another.");
    task.rule = "So it is.";
    const auto check = [&](const Mechanism& drawing) {
      return checkDrawing(task, std::make_shared<const Mechanism>(drawing));
    };
    Mechanism pair = test::example("spur-pair");
    QVERIFY(check(pair).verdict.isRight);
    pair.gearMeshes[0].tailTeeth = 40;
    pair.gearMeshes[0].headTeeth = 60;
    QVERIFY(check(pair).verdict.isRight);
    pair.gearMeshes[0].pitchPoint.reset();
    pair.gearMeshes[0].headTeeth = 61;
    pair.axes[1].point.reset();
    const DrawingVerdict slower = check(pair);
    QCOMPARE(slower.failing, 1);
    QCOMPARE(slower.verdict.reason, std::string("The speed is another."));
    const DrawingVerdict faulty = check(test::example("robot-to-mend"));
    QCOMPARE(faulty.failing, 0);
    QVERIFY(!faulty.verdict.mistake->elements.empty());
    QVERIFY(faulty.verdict.reason.size() > task.conditions[0].reason.size());
  }
};

}  // namespace geargraph

QTEST_APPLESS_MAIN(geargraph::LessonsTest)
#include "test_lessons.moc"
