#pragma once

#include <string_view>

#include "core/foundations/base/expected.h"
#include "core/teaching/lessons/lesson.h"

namespace geargraph {

constexpr int kLessonVersion = 1;

/// Reads a lesson (`lesson.schema.json`). Fails with `syntax`, `format`, `version`, or `schema` with the
/// first error: its JSON pointer, line and column; errors of a mechanism in the lesson are reported at its
/// place. Unknown members are errors, so that typing errors are not overlooked. Cost: O(bytes); nothing is
/// analysed.
[[nodiscard]] Expected<Lesson> readLesson(std::string_view text);

/// Sorts diagnostics in the order of the text and adds the line and column of their pointers, or of the
/// innermost existing value.
[[nodiscard]] Diagnostics placedInText(std::string_view text, const Diagnostics& diagnostics);

}  // namespace geargraph
