#pragma once

#include <string>
#include <string_view>

namespace geargraph::inline drawing {

/// How wide a text is about to be, in px: placing labels must not depend on the fonts of a machine, so that
/// a drawing is the same on screen, in an SVG and in a golden test. The advances are those of DejaVu Sans,
/// one of the wider faces; other characters than ASCII count as a wide letter.
[[nodiscard]] double textWidth(std::string_view utf8, double size, bool bold);

/// The text, cut to at most so many characters with an ellipsis at the end.
[[nodiscard]] std::string elided(std::string_view utf8, std::size_t characters);

}  // namespace geargraph::inline drawing
