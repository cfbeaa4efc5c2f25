#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace geargraph {

// Texts in cells. The two functions of each pair are inverse to each other for every text.

/// With an apostrophe in front where a spreadsheet program would take the text for a formula (it begins with
/// = + - @, a tab or a return), or where unguardedText() would remove one.
[[nodiscard]] std::string guardedText(std::string_view text);
[[nodiscard]] std::string unguardedText(std::string_view cell);

/// Texts in one cell, between bars: "A|E". A bar or a backslash in a text gets a backslash in front.
[[nodiscard]] std::string joinedTexts(const std::vector<std::string>& texts);
/// The inverse; an empty cell gives no texts.
[[nodiscard]] std::vector<std::string> splitTexts(std::string_view cell);

}  // namespace geargraph
