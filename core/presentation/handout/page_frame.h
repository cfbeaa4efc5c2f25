#pragma once

#include <string>
#include <string_view>

#include "core/presentation/handout/page_policy.h"

namespace geargraph {

/// The beginning of a page up to its body, with policy and style. `title` is escaped; `reports`: to a
/// learning platform.
[[nodiscard]] std::string pageHead(const std::string& title, PageKind kind, bool reports);

/// What the page does with the network, a note if there is one, and the program that made it.
[[nodiscard]] std::string pageFooter(bool reports, const std::string& note);

[[nodiscard]] std::string pageScriptElement(std::string_view script);

}  // namespace geargraph
