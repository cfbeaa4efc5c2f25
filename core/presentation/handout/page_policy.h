#pragma once

#include <string>
#include <string_view>

namespace geargraph {

/// A page about a mechanism, or a lesson.
enum class PageKind { handout, lesson };

/// The style of a page, its own script, and its 3D library (three.js, with its licence in the first comment).
[[nodiscard]] std::string_view pageStyle();
[[nodiscard]] std::string_view pageScript(PageKind kind);
[[nodiscard]] std::string_view pageLibrary();
/// The script that reports to a learning platform what was viewed.
[[nodiscard]] std::string_view pageReporter();

/// The Content-Security-Policy of a page: it may run these scripts (the reporting one only if `reports`) and
/// use its own style, and may load and send nothing.
[[nodiscard]] std::string pagePolicy(PageKind kind, bool reports);

}  // namespace geargraph
