#pragma once

#include <string>
#include <vector>

#include "core/foundations/files/json_writer.h"
#include "core/teaching/grading/question.h"

namespace geargraph {

/// The blanks of a question as a table, in a part that scrolls sideways with this name. The element of a
/// blank has the attribute data-field with its position.
[[nodiscard]] std::string questionBlanks(const Question& question, const std::string& name);

/// The members "questions", with keys as in exercises.schema.json, and "shown": for each question the names
/// of its "fields" and "columns" in the current language.
void writeQuestionsWithKeys(JsonWriter& json, const std::vector<Question>& questions);

}  // namespace geargraph
