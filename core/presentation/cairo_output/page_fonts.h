#pragma once

#include <cairo.h>

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "core/presentation/typeset/font_face.h"

namespace geargraph {

/// One character of a line of words, and the face that has it.
struct PlacedCharacter {
  std::string_view utf8;
  cairo_glyph_t glyph;
  cairo_font_face_t* face;
};

/// A text that is valid in a file: blanks for control characters, U+FFFD for invalid UTF-8.
[[nodiscard]] std::string printable(std::string_view utf8);

/// The font faces of a PDF: those of formulas, and a system font for characters that they lack.
class PageFonts {
 public:
  PageFonts();
  ~PageFonts();
  PageFonts(const PageFonts&) = delete;
  PageFonts& operator=(const PageFonts&) = delete;

  [[nodiscard]] cairo_font_face_t* face(FontFace which) const {
    return m_faces[static_cast<std::size_t>(which)];
  }
  /// Places characters one after the other from the origin; `end` is set to the position after the last.
  [[nodiscard]] std::vector<PlacedCharacter> placed(std::string_view utf8, double size, bool bold,
                                                    double& end) const;

 private:
  [[nodiscard]] PlacedCharacter other(std::string_view character, double size, bool bold, double x,
                                      double& advance) const;

  std::array<cairo_font_face_t*, kFontFaces> m_faces{};
  std::array<cairo_font_face_t*, 2> m_others{};  ///< plain, bold
};

}  // namespace geargraph
