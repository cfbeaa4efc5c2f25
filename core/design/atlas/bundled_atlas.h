#pragma once

#include <span>

namespace geargraph {

/// The bytes of resources/atlas/chains.txt, as a list of one file.
[[nodiscard]] std::span<const std::span<const unsigned char>> atlasFiles();

}  // namespace geargraph
