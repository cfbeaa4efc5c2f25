#pragma once

#include <string>

#include "core/presentation/drawing/display_list.h"

namespace geargraph {

/// A drawing as a `tikzpicture` for LaTeX (package tikz), on a light sheet without background: strokes and
/// fills as on screen, text in the document's sans serif face. `points`: of a px of the drawing, TeX points.
[[nodiscard]] std::string tikzOf(const DisplayList& list, double points);

}  // namespace geargraph
