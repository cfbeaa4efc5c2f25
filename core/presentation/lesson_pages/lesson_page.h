#pragma once

#include <stop_token>
#include <string>

#include "core/foundations/base/expected.h"
#include "core/presentation/handout/handout.h"
#include "core/teaching/lessons/prepared_step.h"

namespace geargraph {

/// A lesson as one HTML file that any browser plays offline, with the grader of handouts: text, drawing,
/// fields and hints of each step, one step at a time, or all of them without scripts. At the end fresh
/// questions are asked, further ones where they are not right at the first check. What has to be drawn is
/// described, with one drawing that is right: the page has no editor. Texts of the lesson are as its author
/// wrote them, all others in the current language.
///
/// Answers are packed in the file: hidden, not secret. The result is meaningless if `stop` was requested.
/// Fails where a step cannot be prepared, with its pointer. Cost: that of preparing and drawing each step and
/// kSpareQuestions fresh questions.
[[nodiscard]] Expected<std::string> lessonHtml(const Lesson& lesson, const ExampleSource& examples,
                                               HandoutUse use = HandoutUse::alone,
                                               const std::stop_token& stop = {});

/// The fresh questions that a page brings, of which it asks at least kFreshQuestions.
constexpr int kSpareQuestions = 8;

}  // namespace geargraph
