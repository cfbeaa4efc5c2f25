#include <QTest>

#include "core/teaching/lessons/course.h"
#include "core/teaching/lessons/lesson_checker.h"
#include "core/teaching/lessons/practice.h"
#include "tests/core/support/example_files.h"

namespace geargraph {

/// A sheet of questions is played like a lesson.
class PracticeTest : public QObject {
  Q_OBJECT

 private slots:
  void everyExampleIsPractised() {
    for (const std::string& name : test::exampleNames()) {
      const Mechanism mechanism = test::example(name);
      if (mechanism.n() > kMaxExerciseLinks) continue;
      const ExerciseSource source(mechanism);
      SheetPlan plan;
      plan.kinds = offeredKinds(source);
      plan.seed = 3;
      if (plan.kinds.empty()) continue;
      const Lesson lesson = practiceLesson(source, plan, 2);
      QCOMPARE(lesson.steps.size(), plan.kinds.size());
      QVERIFY(lesson.id.empty());
      const SheetVariant sheet = makeVariant(source, plan, 2);
      for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
        const auto prepared = prepareStep(lesson, i, bundledExample);
        QVERIFY2(prepared.has_value(), name.c_str());
        QCOMPARE(*prepared->question, sheet.questions[i]);
        QCOMPARE(prepared->mechanism->n(), mechanism.n());
        QCOMPARE(lesson.steps[i].title, std::string(kindTitle(plan.kinds[i])));
      }
      const Diagnostics faults = checkLesson(lesson, bundledExample);
      QVERIFY2(faults.empty(), faults.empty() ? "" : faults.front().message.c_str());
    }
  }
};

}  // namespace geargraph

QTEST_APPLESS_MAIN(geargraph::PracticeTest)
#include "test_practice.moc"
