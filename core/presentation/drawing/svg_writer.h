#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/presentation/drawing/display_list.h"

namespace geargraph::inline drawing {

/// How a drawing lies on its sheet.
struct SheetLook {
  Theme theme = Theme::light;
  bool transparent = false;  ///< without the ground of the theme
  double margin = 16;        ///< px beyond the outermost mark
  struct Size {
    int width = 0;
    int height = 0;
  };
  std::optional<Size> size = {};  ///< px: the drawing in the middle, as large as it fits; none: its own size
};

/// The part of the plane that the sheet shows: all marks with the margin, widened to the shape of the size.
[[nodiscard]] Extent sheetOf(const DisplayList& list, const SheetLook& look);

/// An SVG 1.1 of a drawing: strokes and fills as on screen, text as text that can be selected and searched,
/// one group a mark's element with its list and id as data attributes.
[[nodiscard]] std::string svgOf(const DisplayList& list, const SheetLook& look, std::string_view title = {});

}  // namespace geargraph::inline drawing
