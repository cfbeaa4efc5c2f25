#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/teaching/grading/question.h"

namespace geargraph::inline grading {

/// An answer in which this mistake is made and that is not accepted, as near the question's solution as its
/// conditions allow: for corpora by which graders are compared. If possible one that no mistake before it
/// explains. Nothing where none is found among some thousand candidates.
/// @pre the mistake is an element of question.mistakes
[[nodiscard]] std::optional<std::vector<std::string>> wrongAnswer(const Question& question,
                                                                  const Mistake& mistake);

}  // namespace geargraph::inline grading
