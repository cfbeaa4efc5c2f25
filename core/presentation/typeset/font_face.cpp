#include "core/presentation/typeset/font_face.h"

#include <ft2build.h>
#include FT_FREETYPE_H

#include <array>
#include <unordered_map>

#include "core/foundations/base/contract.h"
#include "core/presentation/typeset/font_data.h"

namespace geargraph {
namespace {

using Glyphs = std::unordered_map<char32_t, GlyphMetrics>;

GlyphMetrics metricsOf(FT_Face face, FT_UInt glyph) {
  GEARGRAPH_REQUIRE(FT_Load_Glyph(face, glyph, FT_LOAD_NO_SCALE) == 0);
  const FT_Glyph_Metrics& read = face->glyph->metrics;
  const double em = face->units_per_EM;
  const auto left = static_cast<double>(read.horiBearingX), top = static_cast<double>(read.horiBearingY);
  return {glyph,     static_cast<double>(read.horiAdvance) / em,
          left / em, (left + static_cast<double>(read.width)) / em,
          top / em,  (static_cast<double>(read.height) - top) / em};
}

Glyphs glyphsOf(FT_Library library, FontFace which) {
  Glyphs glyphs;
  const auto bytes = fontFile(which);
  FT_Face face = nullptr;
  GEARGRAPH_REQUIRE(FT_New_Memory_Face(library, bytes.data(), static_cast<FT_Long>(bytes.size()), 0, &face) ==
                    0);
  FT_UInt glyph = 0;
  for (FT_ULong character = FT_Get_First_Char(face, &glyph); glyph != 0;
       character = FT_Get_Next_Char(face, character, &glyph)) {
    glyphs[static_cast<char32_t>(character)] = metricsOf(face, glyph);
  }
  FT_Done_Face(face);
  return glyphs;
}

std::array<Glyphs, kFontFaces> readFaces() {
  std::array<Glyphs, kFontFaces> faces;
  FT_Library library = nullptr;
  GEARGRAPH_REQUIRE(FT_Init_FreeType(&library) == 0);
  for (int i = 0; i < kFontFaces; ++i)
    faces[static_cast<std::size_t>(i)] = glyphsOf(library, static_cast<FontFace>(i));
  FT_Done_FreeType(library);
  return faces;
}

}  // namespace

std::span<const unsigned char> fontFile(FontFace face) {
  return fontFiles()[static_cast<std::size_t>(face)];
}

std::optional<GlyphMetrics> glyphMetrics(FontFace face, char32_t character) {
  static const std::array<Glyphs, kFontFaces> faces = readFaces();
  const Glyphs& glyphs = faces[static_cast<std::size_t>(face)];
  const auto found = glyphs.find(character);
  return found == glyphs.end() ? std::nullopt : std::optional(found->second);
}

char32_t takeCharacter(std::string_view& text) {
  GEARGRAPH_REQUIRE(!text.empty());
  constexpr char32_t kNone = 0xFFFD;
  const auto first = static_cast<unsigned char>(text.front());
  text.remove_prefix(1);
  if (first < 0x80) return first;
  const int more = first >= 0xF0 ? 3 : first >= 0xE0 ? 2 : 1;
  if (first < 0xC0 || first > 0xF7) return kNone;
  char32_t character = first & (0x3FU >> more);
  for (int i = 0; i < more; ++i) {
    if (text.empty() || (static_cast<unsigned char>(text.front()) & 0xC0U) != 0x80U) return kNone;
    character = (character << 6U) | (static_cast<unsigned char>(text.front()) & 0x3FU);
    text.remove_prefix(1);
  }
  const bool isSurrogate = character >= 0xD800 && character < 0xE000;
  return isSurrogate || character > 0x10FFFF ? kNone : character;
}

}  // namespace geargraph
