#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/foundations/base/expected.h"
#include "core/presentation/drawing/display_list.h"
#include "core/presentation/drawing/svg_writer.h"

namespace geargraph {

/// The file formats of a drawing. SVG and PDF are vector formats with selectable text.
enum class PictureForm { svg, pdf, png };

/// "svg", "pdf", "png"
[[nodiscard]] std::string_view pictureFormName(PictureForm form);
[[nodiscard]] std::optional<PictureForm> pictureFormFromName(std::string_view name);

/// Longest side of a PNG; an SVG or PDF may be as large as its drawing.
constexpr int kMaxDrawingPixels = 16'384;

/// Paints a drawing over an image (red, green, blue, straight alpha), with `scale` pixels per unit, from its
/// upper left corner. False if memory is exhausted.
[[nodiscard]] bool paintOver(std::span<std::uint8_t> rgba, int width, int height, const DisplayList& list,
                             double scale, Theme theme);

struct DrawingPicture {
  PictureForm form = PictureForm::svg;
  SheetStyle style = {};
  /// PNG without a size: pixels for a unit of the sheet.
  double scale = 2;
  std::string title = {};  ///< of the document, stored as metadata of a PDF or SVG
};

/// The bytes of the file. The drawing's unit is a CSS pixel, three quarters of a point in PDF. Fails with
/// `graphics` if a PNG would be larger than kMaxDrawingPixels or memory is exhausted.
/// Cost: linear in the marks, for PNG in the pixels too.
[[nodiscard]] Expected<std::string> pictureOf(const DisplayList& list, const DrawingPicture& picture);

}  // namespace geargraph
