#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace geargraph {

/// For listed(): no limit.
constexpr std::size_t kAllNames = static_cast<std::size_t>(-1);

/// Names in a sentence: "8, 9 and 12"; of more than `most` the first ones, "8, 9 and 4 more".
[[nodiscard]] std::string listed(const std::vector<std::string>& names, std::size_t most,
                                 const char* last = "and");

/// The text escaped for content or attributes of XML 1.0; control characters, which XML does not allow,
/// become blanks.
[[nodiscard]] std::string escapedXml(std::string_view text);

}  // namespace geargraph
