#pragma once

#include <string>
#include <string_view>

namespace geargraph {

/// The estimated width of a text, px: label placement must not depend on the fonts of a machine, so that a
/// drawing is the same on screen, in an SVG and in a golden test. The advances are those of DejaVu Sans, one
/// of the wider faces; characters other than ASCII count as a wide letter.
[[nodiscard]] double textWidth(std::string_view utf8, double size, bool bold);

/// The text, shortened to at most `characters` with an ellipsis at the end.
[[nodiscard]] std::string elided(std::string_view utf8, std::size_t characters);

}  // namespace geargraph
