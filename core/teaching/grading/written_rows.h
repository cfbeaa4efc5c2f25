#pragma once

#include <string>
#include <vector>

#include "core/teaching/grading/question.h"

namespace geargraph {

/// The answer, where a row of a table that is written into its first cell fills the row: "i15,1,0" or
/// "-1; 0,5". Only where that cell cannot be read by itself, the other cells of the row are blank, and the
/// row has as many entries as cells. Semicolons and tabs separate entries, and commas unless they are
/// decimal.
[[nodiscard]] std::vector<std::string> withRowsSpread(const Question& question,
                                                      std::vector<std::string> answer);

}  // namespace geargraph
