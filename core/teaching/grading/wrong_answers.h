#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/teaching/grading/question.h"

namespace geargraph {

/// An answer with this mistake that is not accepted, as near to the question's solution as its conditions
/// allow: for test corpora of graders. If possible one that no earlier mistake explains. std::nullopt if none
/// is found among some thousand candidates.
/// @pre the mistake is an element of question.mistakes
[[nodiscard]] std::optional<std::vector<std::string>> wrongAnswer(const Question& question,
                                                                  const Mistake& mistake);

}  // namespace geargraph
