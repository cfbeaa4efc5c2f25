#include "core/presentation/cairo_output/picture.h"

#include <array>
#include <cmath>

#include "core/foundations/base/translation.h"
#include "core/presentation/cairo_output/cairo_surface.h"

namespace geargraph {
namespace {

constexpr std::array<std::string_view, 3> kNames{"svg", "pdf", "png"};

Diagnostics failure(std::string message) {
  Diagnostic diagnostic;
  diagnostic.code = Code::graphics;
  diagnostic.message = std::move(message);
  return {diagnostic};
}

Expected<std::string> pngOf(const DisplayList& list, const DrawingPicture& picture) {
  const Extent sheet = sheetOf(list, picture.style);
  const double scale = picture.style.size ? picture.style.size->width / (2 * sheet.halfWidth) : picture.scale;
  const double width = std::round(2 * sheet.halfWidth * scale);
  const double height = std::round(2 * sheet.halfHeight * scale);
  if (!(std::max(width, height) <= kMaxDrawingPixels)) {
    return failure(
        translated("The picture would be more than %1 pixels wide or high: give it a smaller size, or "
                   "write SVG or PDF.",
                   {std::to_string(kMaxDrawingPixels)}));
  }
  CairoSurface surface =
      CairoSurface::image(static_cast<int>(std::max(width, 1.0)), static_cast<int>(std::max(height, 1.0)));
  surface.play(list, sheet, scale, picture.style);
  std::optional<std::string> bytes = surface.png();
  if (!bytes) return failure(translated("There is not enough memory for the picture."));
  return std::move(*bytes);
}

Expected<std::string> pdfOf(const DisplayList& list, const DrawingPicture& picture) {
  constexpr double kPoints = 0.75;           // a CSS pixel
  constexpr double kMaxPageLength = 14'400;  // points: what readers take
  const Extent sheet = sheetOf(list, picture.style);
  double scale = kPoints;
  if (picture.style.size) scale *= picture.style.size->width / (2 * sheet.halfWidth);
  const double longest = 2 * std::max(sheet.halfWidth, sheet.halfHeight);
  scale = std::min(scale, kMaxPageLength / longest);
  CairoSurface surface =
      CairoSurface::pdf(2 * sheet.halfWidth * scale, 2 * sheet.halfHeight * scale, picture.title);
  surface.play(list, sheet, scale, picture.style);
  std::optional<std::string> bytes = surface.finished();
  if (!bytes) return failure(translated("There is not enough memory for the picture."));
  return std::move(*bytes);
}

}  // namespace

std::string_view pictureFormName(PictureForm form) {
  return kNames[static_cast<std::size_t>(form)];
}

std::optional<PictureForm> pictureFormFromName(std::string_view name) {
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    if (kNames[i] == name) return static_cast<PictureForm>(i);
  }
  return std::nullopt;
}

Expected<std::string> pictureOf(const DisplayList& list, const DrawingPicture& picture) {
  switch (picture.form) {
    case PictureForm::svg:
      return svgOf(list, picture.style, picture.title);
    case PictureForm::pdf:
      return pdfOf(list, picture);
    case PictureForm::png:
      return pngOf(list, picture);
  }
  GEARGRAPH_REQUIRE(false);
}

bool paintOver(std::span<std::uint8_t> rgba, int width, int height, const DisplayList& list, double scale,
               Theme theme) {
  CairoSurface surface = CairoSurface::image(width, height);
  SheetStyle style;
  style.theme = theme;
  style.transparent = true;
  surface.play(list, Extent::spanning({0, 0}, {width / scale, height / scale}), scale, style);
  return surface.layOver(rgba);
}

}  // namespace geargraph
