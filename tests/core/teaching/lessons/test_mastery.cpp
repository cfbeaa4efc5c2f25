#include <QTest>
#include <set>

#include "core/teaching/lessons/course.h"
#include "core/teaching/lessons/lesson_checker.h"
#include "core/teaching/lessons/lesson_reader.h"
#include "core/teaching/lessons/mastery.h"

namespace geargraph {

/// Fresh questions about lessons, and the test that tells where to begin.
class MasteryTest : public QObject {
  Q_OBJECT

  static Question asked(const Lesson& lesson, std::size_t step) {
    const auto prepared = prepareStep(lesson, step, bundledExample);
    if (!prepared || !prepared->question) qFatal("%s, step %zu", lesson.id.c_str(), step);
    return *prepared->question;
  }

 private slots:
  void everyLessonHasFreshQuestions() {
    for (const Lesson& lesson : course()) {
      QVERIFY2(!practiceOf(lesson).empty(), lesson.id.c_str());
      Lesson longer = lesson;
      for (int number = 0; number < kFreshQuestions; ++number)
        longer = withFreshStep(std::move(longer), 7, number);
      QCOMPARE(longer.steps.size(), lesson.steps.size() + kFreshQuestions);
      std::set<std::string> different;
      for (std::size_t step = lesson.steps.size(); step < longer.steps.size(); ++step) {
        const Question question = asked(longer, step);
        QVERIFY(grade(question, question.solution).isRight);
        std::string text = question.prompt + question.formula + longer.steps[step].document.example;
        for (const std::string& value : question.solution) text += '|' + value;
        different.insert(std::move(text));
        QVERIFY(!longer.steps[step].hints.empty() && !longer.steps[step].title.empty());
      }
      QVERIFY2(different.size() >= 2, lesson.id.c_str());
    }
  }

  void theSeedDecides() {
    const auto& lessons = course();
    const Lesson& lesson = lessons[4];
    QCOMPARE(asked(withFreshStep(lesson, 3, 0), lesson.steps.size()),
             asked(withFreshStep(lesson, 3, 0), lesson.steps.size()));
    std::set<std::string> prompts;
    for (std::uint64_t seed = 0; seed < 20; ++seed)
      prompts.insert(asked(withFreshStep(lesson, seed, 0), lesson.steps.size()).prompt);
    QVERIFY(prompts.size() > 1);
  }

  /// Further fresh steps do not become what fresh steps are made of.
  void freshStepsAreMadeOfTheLessonsOwn() {
    const Lesson& lesson = course()[6];
    const std::size_t tasks = practiceOf(lesson).size();
    Lesson longer = lesson;
    for (int number = 0; number < 5; ++number) longer = withFreshStep(std::move(longer), 1, number);
    QCOMPARE(practiceOf(longer).size(), tasks);
  }

  void theStartTestAsksAboutEachLesson() {
    const StartTest test = startTest(course(), 11);
    QCOMPARE(test.lesson.steps.size(), course().size());
    QCOMPARE(test.lesson.id, std::string(kStartTestId));
    for (std::size_t i = 0; i < test.lessons.size(); ++i) {
      QCOMPARE(test.lessons[i], i);
      QVERIFY(test.lesson.steps[i].text.find(course()[i].title) != std::string::npos);
      (void)asked(test.lesson, i);
    }
  }

  void practiceIsReadAndChecked() {
    const std::string text =
        R"({"format": "geargraph-lesson", "version": 1, "id": "a", "title": "A", "minutes": 1,
      "goal": "b", "example": "spur-pair", "practice": [PRACTICE],
      "steps": [{"title": "t", "text": "w", "hints": ["h"], "task": {"kind": "exercise", "exercise": "teeth"}}]})";
    const auto lessonWith = [&](const std::string& practice) {
      std::string with = text;
      return readLesson(with.replace(with.find("PRACTICE"), 8, practice));
    };
    const auto lesson = lessonWith(R"({"exercise": "teeth"}, {"exercise": "freedom", "example": "robot"})");
    QVERIFY(lesson.has_value());
    QCOMPARE(lesson->practice.size(), std::size_t{2});
    QCOMPARE(lesson->practice[0].document.example, std::string("spur-pair"));
    QCOMPARE(lesson->practice[1].document.example, std::string("robot"));
    QVERIFY(checkLesson(*lesson, bundledExample).empty());
    QCOMPARE(lessonWith(R"({"exercise": "riddle"})").error().front().pointer,
             std::string("/practice/0/exercise"));
    QCOMPARE(lessonWith(R"({"exercise": "teeth", "seed": 1})").error().front().pointer,
             std::string("/practice/0/seed"));
    const auto unfit = lessonWith(R"({"exercise": "teeth"}, {"exercise": "brakes"})");
    QVERIFY(unfit.has_value());
    const Diagnostics faults = checkLesson(*unfit, bundledExample);
    QCOMPARE(faults.size(), std::size_t{1});
    QCOMPARE(faults.front().pointer, std::string("/practice/1"));
  }
};

}  // namespace geargraph

QTEST_APPLESS_MAIN(geargraph::MasteryTest)
#include "test_mastery.moc"
