#pragma once

#include <stop_token>

#include "core/teaching/lessons/prepared_step.h"

namespace geargraph::inline lessons {

/// Acts as a learner: solves every task and makes every mistake that the lesson names. Findings, with JSON
/// pointers: a step that cannot be prepared, a solution that is not accepted, a mistake whose example is
/// accepted or gets another reason, a term that the glossary does not have. None if the lesson can be
/// taught, or if `stop` was requested meanwhile. Cost: a preparation of each step, and an analysis of each
/// drawing.
[[nodiscard]] Diagnostics checkLesson(const Lesson& lesson, const ExampleSource& examples,
                                      const std::stop_token& stop = {});

/// The answer in which the mistake is made: the author's example, or the solution with the first values of
/// the mistake in its fields. @pre the question is made of the task
[[nodiscard]] std::vector<std::string> exampleOf(const TaskMistake& mistake, const Question& question);

}  // namespace geargraph::inline lessons
