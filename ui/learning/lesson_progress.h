#pragma once

#include <vector>

#include "core/teaching/lessons/lesson.h"

namespace geargraph {

constexpr int kStepPoints = 2;  ///< for a right answer at the first check, without a hint
constexpr int kNotDone = -1;

/// A learner's progress in a lesson; stored in the settings under the lesson's id, if it has one.
struct LessonProgress {
  int step = 0;             ///< to continue with
  std::vector<int> points;  ///< by step; kNotDone: not worked on yet

  [[nodiscard]] int score() const;
  [[nodiscard]] int doneSteps() const;
  [[nodiscard]] bool isComplete() const { return doneSteps() == static_cast<int>(points.size()); }
};

/// The stored progress, adapted to the present number of steps.
[[nodiscard]] LessonProgress progressOf(const Lesson& lesson);
void saveProgress(const Lesson& lesson, const LessonProgress& progress);

}  // namespace geargraph
