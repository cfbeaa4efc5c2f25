#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace geargraph {

/// The KaTeX fonts in which formulas are set; all are embedded in the program.
enum class FontFace { main, bold, italic, size1, size2, size3, size4 };
constexpr int kFontFaces = 7;

/// The TrueType file of a face; static data.
[[nodiscard]] std::span<const unsigned char> fontFile(FontFace face);

/// A glyph's index in its face and its metrics, in em at size 1, upwards positive.
struct GlyphMetrics {
  std::uint32_t glyph = 0;
  double advance = 0;
  double left = 0, right = 0;  ///< of the ink
  double height = 0;           ///< of the ink above the baseline
  double depth = 0;            ///< of the ink below the baseline; negative where the ink stays above it

  /// How far slanted ink extends beyond the advance.
  [[nodiscard]] double slant() const { return right > advance ? right - advance : 0; }
};

/// std::nullopt if the face has no such character. Cost: a look-up; the first call reads all faces.
/// Thread-safe.
[[nodiscard]] std::optional<GlyphMetrics> glyphMetrics(FontFace face, char32_t character);

/// Removes and returns the next UTF-8 character; U+FFFD for invalid bytes.
/// @pre text is not empty
[[nodiscard]] char32_t takeCharacter(std::string_view& text);

}  // namespace geargraph
