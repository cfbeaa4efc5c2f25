#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/teaching/grading/member_reader.h"
#include "core/teaching/grading/question.h"

namespace geargraph::inline grading {

/// Reads a member with conditions, as in exercises.schema.json. Whether they fit the fields of a question is
/// asked by unsoundPart().
[[nodiscard]] std::vector<Condition> readConditions(MemberReader& reader, const JsonValue& object,
                                                    std::string_view name, const std::string& pointer);

/// The member of what keeps a question from being graded: "fields", "table", "solution", "accepted" or
/// "mistakes"; std::nullopt where it can be.
[[nodiscard]] std::optional<std::string> unsoundPart(const Question& question);

}  // namespace geargraph::inline grading
