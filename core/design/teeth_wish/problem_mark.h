#pragma once

#include <string>
#include <string_view>

namespace geargraph {

/// {"document": ..., "wish": ...} in one line with canonical spaces. @pre both are JSON
[[nodiscard]] std::string problemText(std::string_view document, std::string_view wish);

/// 16 hexadecimal digits of a text (FNV-1a): recognises a changed problem, and is no protection against one
/// who wants to deceive.
[[nodiscard]] std::string markOf(std::string_view text);

}  // namespace geargraph
