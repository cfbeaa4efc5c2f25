#pragma once

#include <optional>
#include <vector>

#include "core/presentation/drawing/display_list.h"

namespace geargraph {

/// The topmost element at a point; `reach` (px) enlarges the outlines, for a small drawing on a large screen.
/// Among several of one depth the nearest is taken. Cost: O(outlines).
[[nodiscard]] std::optional<ElementId> elementAt(const std::vector<Outline>& outlines, CanvasPoint point,
                                                 double reach = 0);

/// The elements all of whose outlines are inside the rectangle, each once, in the order of the list.
[[nodiscard]] std::vector<ElementId> elementsInside(const std::vector<Outline>& outlines, const Extent& area);

}  // namespace geargraph
