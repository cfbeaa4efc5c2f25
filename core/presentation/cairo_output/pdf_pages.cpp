#include "core/presentation/cairo_output/pdf_pages.h"

#include <cairo-pdf.h>

#include <algorithm>

#include "core/presentation/cairo_output/cairo_surface.h"
#include "core/presentation/cairo_output/page_fonts.h"

namespace geargraph {
namespace {

constexpr const char* kWhole = "Document";  ///< the part around all others, which makes a PDF a tagged one

cairo_status_t append(void* closure, const unsigned char* data, unsigned int length) {
  static_cast<std::string*>(closure)->append(reinterpret_cast<const char*>(data), length);  // NOLINT: bytes
  return CAIRO_STATUS_SUCCESS;
}

void setColor(cairo_t* context, Color color) {
  cairo_set_source_rgb(context, color.red / 255.0, color.green / 255.0, color.blue / 255.0);
}

std::string utf8Of(char32_t character) {
  std::string text;
  if (character < 0x80) return {static_cast<char>(character)};
  if (character < 0x800) {
    text += static_cast<char>(0xC0 | (character >> 6));
  } else {
    text += static_cast<char>(0xE0 | (character >> 12));
    text += static_cast<char>(0x80 | ((character >> 6) & 0x3F));
  }
  return text + static_cast<char>(0x80 | (character & 0x3F));
}

/// Neighbours of one face are one text: `utf8` and `glyphs` go together, a cluster each.
void showText(cairo_t* context, cairo_font_face_t* face, double size, const std::string& utf8,
              const std::vector<cairo_glyph_t>& glyphs, const std::vector<cairo_text_cluster_t>& clusters) {
  cairo_set_font_face(context, face);
  cairo_set_font_size(context, size);
  cairo_show_text_glyphs(context, utf8.data(), static_cast<int>(utf8.size()), glyphs.data(),
                         static_cast<int>(glyphs.size()), clusters.data(), static_cast<int>(clusters.size()),
                         static_cast<cairo_text_cluster_flags_t>(0));
}

}  // namespace

void PdfPages::SurfaceEnd::operator()(cairo_surface_t* surface) const {
  cairo_surface_destroy(surface);
}

void PdfPages::ContextEnd::operator()(cairo_t* context) const {
  cairo_destroy(context);
}

PdfPages::PdfPages(double width, double height, const std::string& title)
    : m_fonts(std::make_unique<PageFonts>()),
      m_surface(cairo_pdf_surface_create_for_stream(&append, &m_bytes, width, height)),
      m_context(cairo_create(m_surface.get())) {
  cairo_pdf_surface_set_metadata(m_surface.get(), CAIRO_PDF_METADATA_TITLE, printable(title).c_str());
  cairo_pdf_surface_set_metadata(m_surface.get(), CAIRO_PDF_METADATA_CREATOR, "GearGraph");
  beginPart(kWhole);
}

PdfPages::~PdfPages() = default;

double PdfPages::widthOf(std::string_view utf8, double size, bool bold) const {
  double end = 0;
  (void)m_fonts->placed(utf8, size, bold, end);
  return end;
}

void PdfPages::words(std::string_view utf8, double x, double y, const Words& style) {
  double end = 0;
  const std::vector<PlacedCharacter> characters = m_fonts->placed(utf8, style.size, style.bold, end);
  setColor(m_context.get(), style.color);
  for (std::size_t i = 0; i < characters.size();) {
    std::string text;
    std::vector<cairo_glyph_t> glyphs;
    std::vector<cairo_text_cluster_t> clusters;
    cairo_font_face_t* face = characters[i].face;
    for (; i < characters.size() && characters[i].face == face; ++i) {
      text += characters[i].utf8;
      glyphs.push_back({characters[i].glyph.index, x + characters[i].glyph.x, y});
      clusters.push_back({static_cast<int>(characters[i].utf8.size()), 1});
    }
    showText(m_context.get(), face, style.size, text, glyphs, clusters);
  }
}

void PdfPages::formula(const FormulaBox& box, double x, double y, double size, Color ink, Color label) {
  cairo_t* context = m_context.get();
  const auto joins = [](const PlacedGlyph& a, const PlacedGlyph& b) {
    return a.face == b.face && a.size == b.size && a.ink == b.ink;
  };
  for (std::size_t i = 0; i < box.glyphs.size();) {
    const PlacedGlyph& first = box.glyphs[i];
    std::string text;
    std::vector<cairo_glyph_t> glyphs;
    std::vector<cairo_text_cluster_t> clusters;
    for (; i < box.glyphs.size() && joins(first, box.glyphs[i]); ++i) {
      const PlacedGlyph& glyph = box.glyphs[i];
      const std::string character = utf8Of(glyph.character);
      text += character;
      glyphs.push_back({glyph.glyph, x + glyph.x * size, y + glyph.y * size});
      clusters.push_back({static_cast<int>(character.size()), 1});
    }
    setColor(context, first.ink == FormulaInk::label ? label : ink);
    showText(context, m_fonts->face(first.face), first.size * size, text, glyphs, clusters);
  }
  setColor(context, ink);
  for (const PlacedRule& rule : box.rules) {
    if (rule.dashed) {
      const double dash = 0.3 * size, middle = x + (rule.x + rule.width / 2) * size;
      cairo_set_dash(context, &dash, 1, 0);
      cairo_set_line_width(context, rule.width * size);
      cairo_move_to(context, middle, y + rule.y * size);
      cairo_line_to(context, middle, y + (rule.y + rule.height) * size);
      cairo_stroke(context);
      cairo_set_dash(context, nullptr, 0, 0);
    } else {
      cairo_rectangle(context, x + rule.x * size, y + rule.y * size, rule.width * size, rule.height * size);
      cairo_fill(context);
    }
  }
}

void PdfPages::rule(double x, double y, double width, Color color) {
  constexpr double kThickness = 0.5;
  setColor(m_context.get(), color);
  cairo_rectangle(m_context.get(), x, y - kThickness / 2, width, kThickness);
  cairo_fill(m_context.get());
}

void PdfPages::drawing(const DisplayList& list, double x, double y, double width, double height) {
  SheetStyle style;
  style.transparent = true;
  const Extent sheet = sheetOf(list, style);
  const double scale = std::min(width / (2 * sheet.halfWidth), height / (2 * sheet.halfHeight));
  cairo_save(m_context.get());
  cairo_translate(m_context.get(), x + (width - 2 * sheet.halfWidth * scale) / 2,
                  y + (height - 2 * sheet.halfHeight * scale) / 2);
  playOn(m_context.get(), list, sheet, scale, style);
  cairo_restore(m_context.get());
}

void PdfPages::beginPart(const char* name) {
  cairo_tag_begin(m_context.get(), name, nullptr);
}

void PdfPages::endPart(const char* name) {
  cairo_tag_end(m_context.get(), name);
}

void PdfPages::bookmark(int level, const std::string& title, double y) {
  const std::string place = "page=" + std::to_string(m_page) + " pos=[0 " +
                            std::to_string(static_cast<int>(std::max(0.0, y))) + "]";
  const int parent = level == 1 ? CAIRO_PDF_OUTLINE_ROOT : m_chapter;
  const auto flags = level == 1 ? CAIRO_PDF_OUTLINE_FLAG_OPEN : static_cast<cairo_pdf_outline_flags_t>(0);
  const int added =
      cairo_pdf_surface_add_outline(m_surface.get(), parent, title.c_str(), place.c_str(), flags);
  if (level == 1) m_chapter = added;
}

void PdfPages::endPage() {
  cairo_show_page(m_context.get());
  ++m_page;
}

std::optional<std::string> PdfPages::finished() {
  endPart(kWhole);
  const bool painted = cairo_status(m_context.get()) == CAIRO_STATUS_SUCCESS;
  m_context.reset();
  cairo_surface_finish(m_surface.get());
  if (!painted || cairo_surface_status(m_surface.get()) != CAIRO_STATUS_SUCCESS) return std::nullopt;
  return std::move(m_bytes);
}

}  // namespace geargraph
