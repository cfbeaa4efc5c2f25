#pragma once

#include <vector>

#include "core/teaching/lessons/lesson.h"

namespace geargraph::inline ui_lessons {

constexpr int kStepPoints = 2;  ///< for a step that is right at the first check, without a hint
constexpr int kNotDone = -1;

/// How far a learner has come in a lesson; kept in the settings under the lesson's id, if it has one.
struct LessonProgress {
  int step = 0;             ///< where it is taken up
  std::vector<int> points;  ///< by step; kNotDone: not worked on yet

  [[nodiscard]] int score() const;
  [[nodiscard]] int doneSteps() const;
  [[nodiscard]] bool isComplete() const { return doneSteps() == static_cast<int>(points.size()); }
};

/// What the settings hold, fitted to the steps that the lesson has now.
[[nodiscard]] LessonProgress progressOf(const Lesson& lesson);
void saveProgress(const Lesson& lesson, const LessonProgress& progress);

}  // namespace geargraph::inline ui_lessons
