#include "core/teaching/lessons/practice.h"

#include "core/foundations/base/contract.h"

namespace geargraph {

Lesson practiceLesson(const ExerciseSource& source, const SheetPlan& plan, int variant) {
  GEARGRAPH_REQUIRE(!plan.kinds.empty() && plan.kinds.size() <= kMaxLessonSteps);
  const auto mechanism = std::make_shared<const Mechanism>(source.mechanism());
  SheetVariant sheet = makeVariant(source, plan, variant);
  Lesson lesson;
  lesson.title = plan.title;
  lesson.minutes = 0;
  for (std::size_t i = 0; i < plan.kinds.size(); ++i) {
    Question& question = sheet.questions[i];
    LessonStep step;
    step.title = kindTitle(plan.kinds[i]);
    step.view = stepViewOf(kindView(plan.kinds[i]));
    step.document.mechanism = mechanism;
    step.elements = question.elements;
    step.hints = {std::string(kindHint(plan.kinds[i]))};
    step.task = QuestionTask{std::move(question)};
    lesson.steps.push_back(std::move(step));
  }
  return lesson;
}

}  // namespace geargraph
