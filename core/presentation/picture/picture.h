#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/foundations/base/expected.h"
#include "core/presentation/drawing/display_list.h"
#include "core/presentation/drawing/svg_writer.h"

namespace geargraph::inline picture {

/// The files that a drawing becomes. In SVG and PDF lines stay lines and text stays text.
enum class PictureForm { svg, pdf, png };

/// "svg", "pdf", "png"
[[nodiscard]] std::string_view pictureFormName(PictureForm form);
[[nodiscard]] std::optional<PictureForm> pictureFormFromName(std::string_view name);

/// Longest side of a PNG; an SVG or PDF may be as large as its drawing.
constexpr int kMostDrawingPixels = 16'384;

/// Paints a drawing over a picture of straight red, green, blue and alpha, `scale` pixels to a unit, from its
/// upper left corner. False where memory did not suffice.
[[nodiscard]] bool paintOver(std::span<std::uint8_t> rgba, int width, int height, const DisplayList& list,
                             double scale, Theme theme);

struct DrawingPicture {
  PictureForm form = PictureForm::svg;
  SheetLook look = {};
  /// PNG without a size: pixels for a unit of the sheet.
  double scale = 2;
  std::string title = {};  ///< of the document, for those who look into a PDF or SVG
};

/// The bytes of the file. The drawing's unit is a CSS pixel, three quarters of a point in PDF.
/// Fails with `graphics` where a PNG would be larger than kMostDrawingPixels or memory does not suffice.
/// Cost: linear in the marks, for PNG in the pixels too.
[[nodiscard]] Expected<std::string> pictureOf(const DisplayList& list, const DrawingPicture& picture);

}  // namespace geargraph::inline picture
