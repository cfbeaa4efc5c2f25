#pragma once

#include <vector>

#include "core/presentation/drawing/planar.h"

namespace geargraph {

/// The frame behind a line: short slanted strokes on its side `out` (a unit vector).
[[nodiscard]] std::vector<std::vector<CanvasPoint>> hatching(CanvasPoint from, CanvasPoint to,
                                                             CanvasPoint out);

/// An arrow around a shaft: its arc, in perspective, and the tip.
struct TurnArrow {
  Curve bow;
  std::vector<CanvasPoint> tip;
};
/// `center` on the shaft, `along` its direction, `reach` the distance of the arc from the shaft on either
/// side.
[[nodiscard]] TurnArrow turnArrow(CanvasPoint center, CanvasPoint along, double reach);

}  // namespace geargraph
