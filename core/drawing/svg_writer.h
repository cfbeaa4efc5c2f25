#pragma once

#include <string>

#include "core/drawing/display_list.h"

namespace geargraph {

/// An SVG 1.1 of a drawing: strokes and fills as on screen, text as text that can be selected and searched,
/// one group a mark's element with its list and id as data attributes. The sheet ends `margin` px beyond the
/// outermost mark.
[[nodiscard]] std::string svgOf(const DisplayList& list, Theme theme, double margin = 16);

}  // namespace geargraph
