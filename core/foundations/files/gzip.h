#pragma once

#include <string>
#include <string_view>

namespace geargraph {

/// The bytes as a gzip file (RFC 1952), without name or time: equal bytes give equal files. Cost: O(bytes),
/// some 20 MB per second.
[[nodiscard]] std::string gzip(std::string_view bytes);

}  // namespace geargraph
