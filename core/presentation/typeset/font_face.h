#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace geargraph::inline typeset {

/// The faces of KaTeX that formulas are set in; all are part of the program.
enum class FontFace { main, bold, italic, size1, size2, size3, size4 };
constexpr int kFontFaces = 7;

/// The whole TrueType file of a face. It lives as long as the program.
[[nodiscard]] std::span<const unsigned char> fontFile(FontFace face);

/// A glyph's place in its face and its size, in em at size 1. Upwards is positive.
struct GlyphMetrics {
  std::uint32_t glyph = 0;
  double advance = 0;
  double left = 0, right = 0;  ///< of the ink
  double height = 0;           ///< of the ink above the baseline
  double depth = 0;            ///< of the ink below the baseline; negative where the ink stays above it

  /// How far slanted ink reaches beyond the advance.
  [[nodiscard]] double slant() const { return right > advance ? right - advance : 0; }
};

/// None where the face has no such character. Cost: a look-up; the first call reads all faces. From any
/// thread.
[[nodiscard]] std::optional<GlyphMetrics> glyphMetrics(FontFace face, char32_t character);

/// Of the next character of UTF-8, which is taken off; U+FFFD for what is none.
/// @pre text is not empty
[[nodiscard]] char32_t takeCharacter(std::string_view& text);

}  // namespace geargraph::inline typeset
