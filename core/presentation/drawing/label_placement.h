#pragma once

#include <optional>

#include "core/presentation/drawing/obstacle_grid.h"

namespace geargraph {

/// A label's place, and whether it touches something because there was no free place.
struct LabelPlace {
  CanvasPoint center;
  bool crowded = false;
};

/// A place for a label of this size beside an arrow: as near to the arrow's middle as possible without
/// touching anything, on the side with more room.
[[nodiscard]] LabelPlace placeBeside(const Curve& curve, double halfWidth, double halfHeight,
                                     const ObstacleGrid& taken);

/// Would placeBeside() return `former` again if only the obstacles in `changed` were added or removed? May
/// return false although it would.
[[nodiscard]] bool isStillBeside(const Curve& curve, double halfWidth, double halfHeight,
                                 const LabelPlace& former, const ObstacleGrid& changed);

/// A place for a badge at a node: a free corner, the upper left one first, or a place farther out.
[[nodiscard]] LabelPlace placeAtCorner(CanvasPoint center, int node, const ObstacleGrid& taken);

/// A place for a name under, above or beside a node; std::nullopt if there is no room.
[[nodiscard]] std::optional<CanvasPoint> placeAround(CanvasPoint center, double halfWidth, double halfHeight,
                                                     const ObstacleGrid& taken);

}  // namespace geargraph
