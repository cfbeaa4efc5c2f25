#pragma once

#include "core/presentation/drawing/display_list.h"
#include "core/presentation/drawing/obstacle_grid.h"

namespace geargraph::inline power_drawing {

/// What is drawn there, as obstacles for labels: lines, wide ones by their edges too, filled
/// outlines, boxes of texts.
void addObstacles(ObstacleGrid& taken, const Shape& shape);
void addObstacles(ObstacleGrid& taken, const DisplayList& drawing);

}  // namespace geargraph::inline power_drawing
