#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "core/presentation/drawing/svg_writer.h"

using cairo_surface_t = struct _cairo_surface;  // NOLINT(bugprone-reserved-identifier): cairo's name
using cairo_t = struct _cairo;                  // NOLINT(bugprone-reserved-identifier)

namespace geargraph {

/// Paints the part `sheet` of a drawing at the context's origin, with `scale` context units per unit of the
/// sheet. Changes the context's scale, font and dashes.
void playOn(cairo_t* context, const DisplayList& list, const Extent& sheet, double scale,
            const SheetStyle& style);

/// A PDF page or an image on which cairo paints a drawing.
class CairoSurface {
 public:
  [[nodiscard]] static CairoSurface image(int width, int height);                                ///< pixels
  [[nodiscard]] static CairoSurface pdf(double width, double height, const std::string& title);  ///< points

  /// Paints the part `sheet` of a drawing over the whole surface, with `scale` surface units per unit of the
  /// sheet.
  void play(const DisplayList& list, const Extent& sheet, double scale, const SheetStyle& style);

  /// Composes the image over another one of the same size: four bytes per pixel, red, green, blue, alpha, not
  /// premultiplied. False if memory is exhausted.
  [[nodiscard]] bool layOver(std::span<std::uint8_t> rgba);

  /// The image as a PNG; the whole PDF. std::nullopt if memory is exhausted.
  [[nodiscard]] std::optional<std::string> png();
  [[nodiscard]] std::optional<std::string> finished();

 private:
  explicit CairoSurface(cairo_surface_t* surface, std::unique_ptr<std::string> bytes);

  struct SurfaceEnd {
    void operator()(cairo_surface_t* surface) const;
  };
  struct ContextEnd {
    void operator()(cairo_t* context) const;
  };
  std::unique_ptr<std::string> m_bytes;  ///< the bytes of a PDF written so far; outlives the surface
  std::unique_ptr<cairo_surface_t, SurfaceEnd> m_surface;
  std::unique_ptr<cairo_t, ContextEnd> m_context;
};

}  // namespace geargraph
