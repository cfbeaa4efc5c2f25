#pragma once

#include <span>

namespace geargraph::inline handout {

/// The style of a page, its script, its library and what reports to learning platforms, as they stand in it.
[[nodiscard]] std::span<const std::span<const unsigned char>> pageFiles();

}  // namespace geargraph::inline handout
