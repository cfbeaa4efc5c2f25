#pragma once

#include <string>

namespace geargraph::inline ttgraph {

/// As many names as a sentence about axes and transfer vertices bears.
constexpr std::size_t kMostNames = 8;

/// "three" up to twelve, digits beyond.
[[nodiscard]] std::string countInWords(int count);

}  // namespace geargraph::inline ttgraph
