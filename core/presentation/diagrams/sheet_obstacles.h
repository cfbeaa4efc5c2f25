#pragma once

#include "core/presentation/drawing/display_list.h"
#include "core/presentation/drawing/obstacle_grid.h"

namespace geargraph {

/// Adds a shape or a drawing as obstacles for labels: lines, wide ones with their edges too, filled outlines,
/// boxes of texts.
void addObstacles(ObstacleGrid& taken, const Shape& shape);
void addObstacles(ObstacleGrid& taken, const DisplayList& drawing);

}  // namespace geargraph
