#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/teaching/grading/member_reader.h"
#include "core/teaching/grading/question.h"

namespace geargraph {

/// Reads a member with conditions, as in exercises.schema.json. unsoundPart() checks whether they fit the
/// fields of a question.
[[nodiscard]] std::vector<Condition> readConditions(MemberReader& reader, const JsonValue& object,
                                                    std::string_view name, const std::string& pointer);

/// The member because of which a question cannot be graded: "fields", "table", "solution", "accepted" or
/// "mistakes"; std::nullopt if it can.
[[nodiscard]] std::optional<std::string> unsoundPart(const Question& question);

}  // namespace geargraph
