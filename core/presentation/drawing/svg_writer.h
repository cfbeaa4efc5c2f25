#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/presentation/drawing/display_list.h"

namespace geargraph {

/// The options of a drawing's sheet.
struct SheetStyle {
  Theme theme = Theme::light;
  bool transparent = false;  ///< without the background of the theme
  double margin = 16;        ///< px beyond the outermost mark
  struct Size {
    int width = 0;
    int height = 0;
  };
  std::optional<Size> size = {};  ///< px: the drawing is centred and scaled to fit; none: its own size
};

/// The part of the plane that the sheet shows: all marks with the margin, extended to the aspect ratio of the
/// size.
[[nodiscard]] Extent sheetOf(const DisplayList& list, const SheetStyle& style);

/// An SVG 1.1 of a drawing: strokes and fills as on screen, text as text that can be selected and searched,
/// one group per element, with its list and id as data attributes.
[[nodiscard]] std::string svgOf(const DisplayList& list, const SheetStyle& style,
                                std::string_view title = {});

}  // namespace geargraph
