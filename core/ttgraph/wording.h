#pragma once

#include <string>
#include <vector>

namespace geargraph {

/// "8, 9 and 12"; a long list is cut short and says so.
[[nodiscard]] std::string listed(const std::vector<std::string>& names, const char* last = "and");
/// "three" up to twelve, digits beyond.
[[nodiscard]] std::string countInWords(int count);

}  // namespace geargraph
