#pragma once

#include <string>
#include <string_view>

namespace geargraph::inline handout {

/// The style of a page, its own script, and the library that paints its three dimensions (three.js, with its
/// licence in the first comment).
[[nodiscard]] std::string_view pageStyle();
[[nodiscard]] std::string_view pageScript();
[[nodiscard]] std::string_view pageLibrary();
/// The script that tells a learning platform what was seen.
[[nodiscard]] std::string_view pageReporter();

/// The Content-Security-Policy of a page: it runs these scripts, that which reports only where it `reports`,
/// wears its own style and loads and sends nothing.
[[nodiscard]] std::string pagePolicy(bool reports);

}  // namespace geargraph::inline handout
