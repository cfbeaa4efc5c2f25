#pragma once

#include <span>

namespace geargraph {

/// The files of resources/help, in the order of their names.
[[nodiscard]] std::span<const std::span<const unsigned char>> pageFiles();

}  // namespace geargraph
