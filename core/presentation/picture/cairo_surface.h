#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "core/presentation/drawing/svg_writer.h"

using cairo_surface_t = struct _cairo_surface;  // NOLINT(bugprone-reserved-identifier): cairo's name
using cairo_t = struct _cairo;                  // NOLINT(bugprone-reserved-identifier)

namespace geargraph::inline picture {

/// Paints the part `sheet` of a drawing from the context's origin on, `scale` to a unit of the sheet. The
/// context's scale, font and dashes are changed.
void playOn(cairo_t* context, const DisplayList& list, const Extent& sheet, double scale,
            const SheetLook& look);

/// A page or an image that cairo paints a drawing on.
class CairoSurface {
 public:
  [[nodiscard]] static CairoSurface image(int width, int height);                                ///< pixels
  [[nodiscard]] static CairoSurface pdf(double width, double height, const std::string& title);  ///< points

  /// Paints the part `sheet` of a drawing over all of the surface, `scale` to a unit of the sheet.
  void play(const DisplayList& list, const Extent& sheet, double scale, const SheetLook& look);

  /// Lays the image over one of as many pixels, four bytes each: red, green, blue, not multiplied with alpha.
  /// False where memory did not suffice.
  [[nodiscard]] bool layOver(std::span<std::uint8_t> rgba);

  /// The image as a PNG; the whole PDF. Nothing where memory did not suffice.
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
  std::unique_ptr<std::string> m_bytes;  ///< what a PDF has been written to so far; outlives the surface
  std::unique_ptr<cairo_surface_t, SurfaceEnd> m_surface;
  std::unique_ptr<cairo_t, ContextEnd> m_context;
};

}  // namespace geargraph::inline picture
