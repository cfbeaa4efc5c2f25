#include "core/presentation/cairo_output/page_fonts.h"

#include <cairo-ft.h>

#include <memory>

#include "core/foundations/base/contract.h"

namespace geargraph {
namespace {

constexpr double kBlank = 1.0 / 3;  // of the em, as in print
constexpr const char* kOtherFace = "DejaVu Serif";

struct Library {
  FT_Library library = nullptr;

  Library() { GEARGRAPH_REQUIRE(FT_Init_FreeType(&library) == 0); }
  ~Library() { FT_Done_FreeType(library); }
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;
};

/// A face lives as long as cairo holds it, which may be longer than the fonts live, and the library as long
/// as the last face.
struct HeldFace {
  std::shared_ptr<Library> library;
  FT_Face face;
};
void endFace(void* data) {
  const std::unique_ptr<HeldFace> held(static_cast<HeldFace*>(data));
  FT_Done_Face(held->face);
}

/// A character that a file's text can hold; others look like a blank.
bool isPrintable(char32_t character) {
  const bool isControl = character < 0x20 || (character >= 0x7F && character < 0xA0);
  const bool isNone = (character >= 0xFDD0 && character <= 0xFDEF) || (character & 0xFFFEU) == 0xFFFEU;
  return !isControl && !isNone;
}

cairo_font_face_t* embedded(const std::shared_ptr<Library>& library, FontFace which) {
  const auto bytes = fontFile(which);
  FT_Face face = nullptr;
  GEARGRAPH_REQUIRE(
      FT_New_Memory_Face(library->library, bytes.data(), static_cast<FT_Long>(bytes.size()), 0, &face) == 0);
  cairo_font_face_t* made = cairo_ft_font_face_create_for_ft_face(face, FT_LOAD_NO_HINTING);
  static const cairo_user_data_key_t key{};
  auto held = std::make_unique<HeldFace>(HeldFace{library, face});
  GEARGRAPH_REQUIRE(cairo_font_face_set_user_data(made, &key, held.release(), endFace) ==
                    CAIRO_STATUS_SUCCESS);
  return made;
}

}  // namespace

std::string printable(std::string_view utf8) {
  std::string text;
  while (!utf8.empty()) {
    const std::string_view before = utf8;
    const char32_t character = takeCharacter(utf8);
    if (character == 0xFFFD) {
      text += "\uFFFD";
    } else if (isPrintable(character)) {
      text += before.substr(0, before.size() - utf8.size());
    } else {
      text += ' ';
    }
  }
  return text;
}

PageFonts::PageFonts() {
  const auto library = std::make_shared<Library>();
  for (int i = 0; i < kFontFaces; ++i) {
    m_faces[static_cast<std::size_t>(i)] = embedded(library, static_cast<FontFace>(i));
  }
  for (const bool bold : {false, true}) {
    m_others[bold ? 1 : 0] = cairo_toy_font_face_create(
        kOtherFace, CAIRO_FONT_SLANT_NORMAL, bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  }
}

PageFonts::~PageFonts() {
  for (cairo_font_face_t* face : m_faces) cairo_font_face_destroy(face);
  for (cairo_font_face_t* face : m_others) cairo_font_face_destroy(face);
}

std::vector<PlacedCharacter> PageFonts::placed(std::string_view utf8, double size, bool bold,
                                               double& end) const {
  const FontFace own = bold ? FontFace::bold : FontFace::main;
  std::vector<PlacedCharacter> result;
  end = 0;
  while (!utf8.empty()) {
    std::string_view rest = utf8;
    const char32_t character = takeCharacter(rest);
    const std::string_view text = utf8.substr(0, utf8.size() - rest.size());
    utf8 = rest;
    double advance = kBlank * size;
    if (character == U' ' || !isPrintable(character)) {
      const auto blank = glyphMetrics(own, U' ');
      result.push_back({" ", {blank->glyph, end, 0}, face(own)});
    } else if (const auto metrics = glyphMetrics(own, character)) {
      result.push_back({text, {metrics->glyph, end, 0}, face(own)});
      advance = metrics->advance * size;
    } else {
      result.push_back(other(character == 0xFFFD ? "\uFFFD" : text, size, bold, end, advance));
    }
    end += advance;
  }
  return result;
}

PlacedCharacter PageFonts::other(std::string_view character, double size, bool bold, double x,
                                 double& advance) const {
  cairo_font_face_t* face = m_others[bold ? 1 : 0];
  cairo_matrix_t matrix, still;
  cairo_matrix_init_scale(&matrix, size, size);
  cairo_matrix_init_identity(&still);
  cairo_font_options_t* options = cairo_font_options_create();
  cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
  cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
  cairo_scaled_font_t* font = cairo_scaled_font_create(face, &matrix, &still, options);
  cairo_glyph_t* glyphs = nullptr;
  int count = 0;
  cairo_glyph_t glyph{0, x, 0};
  if (cairo_scaled_font_text_to_glyphs(font, 0, 0, character.data(), static_cast<int>(character.size()),
                                       &glyphs, &count, nullptr, nullptr, nullptr) == CAIRO_STATUS_SUCCESS &&
      count > 0) {
    glyph.index = glyphs[0].index;
    cairo_text_extents_t extents;
    cairo_scaled_font_glyph_extents(font, glyphs, 1, &extents);
    advance = extents.x_advance;
  }
  cairo_glyph_free(glyphs);
  cairo_scaled_font_destroy(font);
  cairo_font_options_destroy(options);
  return {character, glyph, face};
}

}  // namespace geargraph
