#pragma once

#include <string_view>

#include "core/foundations/base/expected.h"
#include "core/teaching/lessons/lesson.h"

namespace geargraph::inline lessons {

constexpr int kLessonVersion = 1;

/// Reads a lesson (`lesson.schema.json`). Fails with `syntax`, `format`, `version`, or `schema` with the
/// first fault: its JSON pointer, line and column; what is wrong with a mechanism that the lesson holds is
/// reported at its place. Members that the format does not have are faults, so that no slip of the pen is
/// overlooked. Cost: O(bytes); nothing is analysed.
[[nodiscard]] Expected<Lesson> readLesson(std::string_view text);

/// The findings, in the order of the text, with line and column of their pointers: of the innermost value
/// that is there.
[[nodiscard]] Diagnostics placedInText(std::string_view text, const Diagnostics& findings);

}  // namespace geargraph::inline lessons
