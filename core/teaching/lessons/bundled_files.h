#pragma once

#include <span>

namespace geargraph {

/// The files of resources/lessons, in their order.
[[nodiscard]] std::span<const std::span<const unsigned char>> lessonFiles();
/// The names of the examples, a line each, then their files.
[[nodiscard]] std::span<const std::span<const unsigned char>> exampleFiles();

}  // namespace geargraph
