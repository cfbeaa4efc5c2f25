#pragma once

#include <string>
#include <string_view>

namespace geargraph::inline files {

/// Bytes in the letters of RFC 4648, section 4, padded. Cost: O(bytes).
[[nodiscard]] std::string base64(std::string_view bytes);

}  // namespace geargraph::inline files
