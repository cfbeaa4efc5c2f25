#pragma once

#include <optional>

#include "core/presentation/drawing/obstacle_grid.h"

namespace geargraph::inline drawing {

/// A label's place, and whether it touches something because there was no free one.
struct LabelPlace {
  SheetPoint center;
  bool crowded = false;
};

/// Where a label of this size goes beside an arrow: as near to its middle as it touches nothing, on the side
/// where it has more room.
[[nodiscard]] LabelPlace placeBeside(const Curve& curve, double halfWidth, double halfHeight,
                                     const ObstacleGrid& taken);

/// Would placeBeside() find `former` again, if only what is in `changed` came or went since? May say no where
/// it would.
[[nodiscard]] bool isStillBeside(const Curve& curve, double halfWidth, double halfHeight,
                                 const LabelPlace& former, const ObstacleGrid& changed);

/// Where a badge goes at a node: a corner of it that is free, the upper left one first, or a place farther
/// out.
[[nodiscard]] LabelPlace placeAtCorner(SheetPoint center, int node, const ObstacleGrid& taken);

/// Where a name goes under, above or beside a node; none where there is no room for it.
[[nodiscard]] std::optional<SheetPoint> placeAround(SheetPoint center, double halfWidth, double halfHeight,
                                                    const ObstacleGrid& taken);

}  // namespace geargraph::inline drawing
