#pragma once

#include <span>

namespace geargraph {

/// The embedded files of a page: style, script, library, the script that reports to learning platforms, and
/// that of lessons.
[[nodiscard]] std::span<const std::span<const unsigned char>> handoutPageFiles();

}  // namespace geargraph
