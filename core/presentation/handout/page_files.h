#pragma once

#include <span>

namespace geargraph {

/// The embedded files of a page: style, script, library, and the script that reports to learning platforms.
[[nodiscard]] std::span<const std::span<const unsigned char>> handoutPageFiles();

}  // namespace geargraph
