#pragma once

#include <string>

namespace geargraph {

/// The most names that one sentence about axes and transfer vertices lists.
constexpr std::size_t kMaxNames = 8;

/// "three" up to twelve, digits beyond.
[[nodiscard]] std::string countInWords(int count);

}  // namespace geargraph
