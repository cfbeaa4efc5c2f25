#pragma once

#include <QDate>
#include <optional>
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

/// When the fresh questions of a lesson were right last, and in how many reviews.
struct LessonMastery {
  QDate on;       ///< invalid: never
  int times = 0;  ///< reviews that came when they were due, and the first time

  [[nodiscard]] bool isMastered() const { return on.isValid(); }
  /// The day from which on it should be reviewed: after 1, 3, 7, 21, then each time 60 days.
  [[nodiscard]] QDate due() const;
};
[[nodiscard]] LessonMastery masteryOf(const Lesson& lesson);
/// A review before it is due does not count, and moves nothing.
void saveMastered(const Lesson& lesson, const QDate& today);

/// What a lesson whose own steps are done still asks for.
enum class ReviewState { none, freshLeft, due };
[[nodiscard]] ReviewState reviewStateOf(const Lesson& lesson, const QDate& today);

/// The position of the lesson with which to begin by the stored answers of the start test; std::nullopt
/// without answers, or if all were right at the first check.
[[nodiscard]] std::optional<std::size_t> lessonToBeginWith(const std::vector<Lesson>& lessons);

}  // namespace geargraph
