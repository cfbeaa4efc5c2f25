#include "core/teaching/lessons/mastery.h"

#include <algorithm>

#include "core/foundations/base/contract.h"
#include "core/foundations/base/translation.h"

namespace geargraph {
namespace {

bool isSameDocument(const LessonDocument& a, const LessonDocument& b) {
  return a.example == b.example && a.mechanism == b.mechanism;
}

LessonStep stepOf(const PracticeTask& task, std::uint64_t seed, int number) {
  LessonStep step;
  step.title = kindTitle(task.kind);
  step.view = stepViewOf(kindView(task.kind));
  step.document = task.document;
  step.hints = {kindHint(task.kind)};
  // Not so near the largest number that no further seed could be tried.
  const std::uint64_t own = ExerciseRandom(seed, 0, static_cast<std::uint64_t>(number)).next() >> 1U;
  step.task = ExerciseTask{task.kind, own, std::nullopt};
  return step;
}

}  // namespace

std::vector<PracticeTask> practiceOf(const Lesson& lesson) {
  if (!lesson.practice.empty()) return lesson.practice;
  std::vector<PracticeTask> tasks;
  for (const LessonStep& step : lesson.steps) {
    const auto* exercise = std::get_if<ExerciseTask>(&step.task);
    if (exercise == nullptr) continue;
    const bool isKnown = std::any_of(tasks.begin(), tasks.end(), [&](const PracticeTask& task) {
      return task.kind == exercise->kind && isSameDocument(task.document, step.document);
    });
    if (!isKnown) tasks.push_back({exercise->kind, step.document});
  }
  return tasks;
}

LessonStep freshStep(const Lesson& lesson, std::uint64_t seed, int number) {
  const std::vector<PracticeTask> tasks = practiceOf(lesson);
  GEARGRAPH_REQUIRE(!tasks.empty());
  return stepOf(tasks[static_cast<std::size_t>(number) % tasks.size()], seed, number);
}

Lesson withFreshStep(Lesson lesson, std::uint64_t seed, int number) {
  LessonStep step = freshStep(lesson, seed, number);
  // The tasks stay those of the lesson's own steps.
  if (lesson.practice.empty()) lesson.practice = practiceOf(lesson);
  lesson.steps.push_back(std::move(step));
  return lesson;
}

StartTest startTest(const std::vector<Lesson>& lessons, std::uint64_t seed) {
  StartTest test;
  test.lesson.id = kStartTestId;
  test.lesson.title = translated("Where to begin");
  test.lesson.minutes = 0;
  for (std::size_t i = 0; i < lessons.size(); ++i) {
    // The last task of a lesson asks for most of what it teaches.
    const std::vector<PracticeTask> tasks = practiceOf(lessons[i]);
    if (tasks.empty()) continue;
    LessonStep step = stepOf(tasks.back(), seed, static_cast<int>(i));
    step.text = translated("After the lesson \u201c%1\u201d you can answer this.", {lessons[i].title});
    test.lesson.steps.push_back(std::move(step));
    test.lessons.push_back(i);
  }
  return test;
}

}  // namespace geargraph
