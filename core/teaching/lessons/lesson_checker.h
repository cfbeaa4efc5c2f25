#pragma once

#include <stop_token>

#include "core/teaching/lessons/prepared_step.h"

namespace geargraph {

/// Tests a lesson by solving every task and making every mistake that the lesson names. Reports with JSON
/// pointers: a step that cannot be prepared, a solution that is not accepted, a mistake whose example is
/// accepted or gets another reason, a term that the glossary does not have. Empty if the lesson is valid, or
/// if `stop` was requested meanwhile. Cost: that of preparing each step, and an analysis of each drawing.
[[nodiscard]] Diagnostics checkLesson(const Lesson& lesson, const ExampleSource& examples,
                                      const std::stop_token& stop = {});

/// An answer with the mistake: the author's example, or the solution with the first values of the mistake in
/// its fields. @pre the question is made of the task
[[nodiscard]] std::vector<std::string> exampleOf(const TaskMistake& mistake, const Question& question);

}  // namespace geargraph
