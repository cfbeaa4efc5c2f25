#pragma once

#include "core/teaching/exercises/exercise_sheet.h"
#include "core/teaching/lessons/lesson.h"

namespace geargraph {

/// A variant of a sheet as a lesson on its mechanism, with one step per question: with hints, feedback and a
/// score like any lesson. Progress is not stored. Cost: that of makeVariant().
/// @pre every kind of the plan is offered, 1 to kMaxLessonSteps of them; 1 <= variant
[[nodiscard]] Lesson practiceLesson(const ExerciseSource& source, const SheetPlan& plan, int variant);

}  // namespace geargraph
