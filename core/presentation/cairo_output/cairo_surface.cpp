#include "core/presentation/cairo_output/cairo_surface.h"

#include <cairo-pdf.h>
#include <cairo.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <numbers>

namespace geargraph {
namespace {

constexpr const char* kFace = "DejaVu Sans";
constexpr double kCapitals = 0.729;  ///< height of that face's digits and capitals, in em

cairo_status_t append(void* closure, const unsigned char* data, unsigned int length) {
  auto& bytes = *static_cast<std::string*>(closure);
  bytes.append(reinterpret_cast<const char*>(data), length);  // NOLINT: bytes are bytes
  return CAIRO_STATUS_SUCCESS;
}

void setColor(cairo_t* context, Color color) {
  cairo_set_source_rgb(context, color.red / 255.0, color.green / 255.0, color.blue / 255.0);
}

void paintSheet(cairo_t* context, Theme theme) {
  setColor(context, colorOf(ColorRole::sheet, theme));
  cairo_paint(context);
}

/// Adds a shape to the path.
struct ShapePath {
  cairo_t* context;

  void operator()(const Circle& circle) const {
    cairo_new_sub_path(context);
    cairo_arc(context, circle.center.x, circle.center.y, circle.radius, 0, 2 * std::numbers::pi);
    cairo_close_path(context);
  }
  void operator()(const Box& box) const {
    const Extent& area = box.extent;
    const double corner = std::min({box.corner, area.halfWidth, area.halfHeight});
    constexpr double kQuarter = std::numbers::pi / 2;
    cairo_new_sub_path(context);
    cairo_arc(context, area.right() - corner, area.top() + corner, corner, -kQuarter, 0);
    cairo_arc(context, area.right() - corner, area.bottom() - corner, corner, 0, kQuarter);
    cairo_arc(context, area.left() + corner, area.bottom() - corner, corner, kQuarter, 2 * kQuarter);
    cairo_arc(context, area.left() + corner, area.top() + corner, corner, 2 * kQuarter, 3 * kQuarter);
    cairo_close_path(context);
  }
  void operator()(const Polyline& line) const {
    cairo_new_sub_path(context);
    for (const CanvasPoint p : line.points) cairo_line_to(context, p.x, p.y);
    if (line.closed) cairo_close_path(context);
  }
  void operator()(const Curve& curve) const {
    cairo_move_to(context, curve.from.x, curve.from.y);
    if (curve.isStraight()) {
      cairo_line_to(context, curve.to.x, curve.to.y);
    } else {
      cairo_curve_to(context, curve.leaving.x, curve.leaving.y, curve.arriving.x, curve.arriving.y,
                     curve.to.x, curve.to.y);
    }
  }
};

void setDash(cairo_t* context, Dash dash) {
  constexpr std::array kDashed{6.5, 4.5};
  constexpr std::array kDashDotted{12.0, 3.0, 2.0, 3.0};
  constexpr std::array kDotted{0.1, 6.0};
  const auto set = [context](const auto& lengths) {
    cairo_set_dash(context, lengths.data(), static_cast<int>(lengths.size()), 0);
  };
  cairo_set_line_cap(context, dash == Dash::dotted ? CAIRO_LINE_CAP_ROUND : CAIRO_LINE_CAP_BUTT);
  if (dash == Dash::solid) cairo_set_dash(context, nullptr, 0, 0);
  if (dash == Dash::dashed) set(kDashed);
  if (dash == Dash::dashDotted) set(kDashDotted);
  if (dash == Dash::dotted) set(kDotted);
}

struct MarkPainter {
  cairo_t* context;
  Theme theme;

  void operator()(const Stroke& stroke) const {
    cairo_new_path(context);
    std::visit(ShapePath{context}, stroke.shape);
    setColor(context, colorOf(stroke.tint, theme));
    cairo_set_line_width(context, stroke.width);
    setDash(context, stroke.dash);
    cairo_stroke(context);
  }
  void operator()(const Fill& fill) const {
    cairo_new_path(context);
    std::visit(ShapePath{context}, fill.shape);
    setColor(context, colorOf(fill.tint, theme));
    cairo_fill(context);
  }
  void operator()(const Text& text) const {
    cairo_select_font_face(context, kFace, CAIRO_FONT_SLANT_NORMAL,
                           text.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(context, text.size);
    cairo_text_extents_t extents;
    cairo_text_extents(context, text.text.c_str(), &extents);
    cairo_move_to(context, text.center.x - extents.x_advance / 2, text.center.y + kCapitals * text.size / 2);
    setColor(context, colorOf(text.tint, theme));
    cairo_show_text(context, text.text.c_str());
  }
};

}  // namespace

void CairoSurface::SurfaceEnd::operator()(cairo_surface_t* surface) const {
  cairo_surface_destroy(surface);
}

void CairoSurface::ContextEnd::operator()(cairo_t* context) const {
  cairo_destroy(context);
}

CairoSurface::CairoSurface(cairo_surface_t* surface, std::unique_ptr<std::string> bytes)
    : m_bytes(std::move(bytes)), m_surface(surface), m_context(cairo_create(surface)) {}

CairoSurface CairoSurface::image(int width, int height) {
  return CairoSurface(cairo_image_surface_create(CAIRO_FORMAT_ARGB32, width, height), nullptr);
}

CairoSurface CairoSurface::pdf(double width, double height, const std::string& title) {
  auto bytes = std::make_unique<std::string>();
  cairo_surface_t* surface = cairo_pdf_surface_create_for_stream(&append, bytes.get(), width, height);
  cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_TITLE, title.c_str());
  cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATOR, "GearGraph");
  return CairoSurface(surface, std::move(bytes));
}

void CairoSurface::play(const DisplayList& list, const Extent& sheet, double scale, const SheetStyle& style) {
  cairo_t* context = m_context.get();
  // What covers the whole page makes cairo forget all before it, the beginning of a part as well.
  if (!style.transparent) paintSheet(context, style.theme);
  SheetStyle marks = style;
  marks.transparent = true;
  // Parts of a PDF; an image has none.
  for (const char* part : {"Document", "Figure"}) cairo_tag_begin(context, part, nullptr);
  playOn(context, list, sheet, scale, marks);
  for (const char* part : {"Figure", "Document"}) cairo_tag_end(context, part);
}

void playOn(cairo_t* context, const DisplayList& list, const Extent& sheet, double scale,
            const SheetStyle& style) {
  if (!style.transparent) paintSheet(context, style.theme);
  // Letters where the lines are, at any size.
  cairo_font_options_t* options = cairo_font_options_create();
  cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
  cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
  cairo_set_font_options(context, options);
  cairo_font_options_destroy(options);
  cairo_scale(context, scale, scale);
  cairo_translate(context, -sheet.left(), -sheet.top());
  for (const Mark& mark : list.marks) std::visit(MarkPainter{context, style.theme}, mark.what);
}

// Cairo's pixels are words of alpha, red, green and blue, colours multiplied with alpha.
bool CairoSurface::layOver(std::span<std::uint8_t> rgba) {
  cairo_surface_flush(m_surface.get());
  if (cairo_status(m_context.get()) != CAIRO_STATUS_SUCCESS) return false;
  const int width = cairo_image_surface_get_width(m_surface.get());
  const int height = cairo_image_surface_get_height(m_surface.get());
  const unsigned char* row = cairo_image_surface_get_data(m_surface.get());
  std::uint8_t* under = rgba.data();
  for (int y = 0; y < height; ++y, row += cairo_image_surface_get_stride(m_surface.get())) {
    for (int x = 0; x < width; ++x, under += 4) {
      std::uint32_t over = 0;
      std::memcpy(&over, row + 4 * x, sizeof over);
      const std::uint32_t alpha = over >> 24;
      if (alpha == 0) continue;
      const std::uint32_t rest = (under[3] * (255 - alpha) + 127) / 255, whole = alpha + rest;
      for (int channel = 0; channel < 3; ++channel) {
        const std::uint32_t colour = (over >> (16 - 8 * channel)) & 255;
        under[channel] = static_cast<std::uint8_t>(
            std::min<std::uint32_t>(255, (colour * 255 + under[channel] * rest + whole / 2) / whole));
      }
      under[3] = static_cast<std::uint8_t>(whole);
    }
  }
  return true;
}

std::optional<std::string> CairoSurface::png() {
  cairo_surface_flush(m_surface.get());
  std::string bytes;
  const bool written =
      cairo_status(m_context.get()) == CAIRO_STATUS_SUCCESS &&
      cairo_surface_write_to_png_stream(m_surface.get(), &append, &bytes) == CAIRO_STATUS_SUCCESS;
  return written ? std::optional(std::move(bytes)) : std::nullopt;
}

std::optional<std::string> CairoSurface::finished() {
  const bool painted = cairo_status(m_context.get()) == CAIRO_STATUS_SUCCESS;
  m_context.reset();
  cairo_surface_finish(m_surface.get());
  if (!painted || cairo_surface_status(m_surface.get()) != CAIRO_STATUS_SUCCESS) return std::nullopt;
  return std::move(*m_bytes);
}

}  // namespace geargraph
