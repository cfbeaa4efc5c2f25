#pragma once

#include <string>
#include <string_view>

namespace geargraph {

/// The bytes in base64 (RFC 4648, section 4) with padding. Cost: O(bytes).
[[nodiscard]] std::string base64(std::string_view bytes);

}  // namespace geargraph
