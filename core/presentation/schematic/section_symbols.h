#pragma once

#include <vector>

#include "core/presentation/drawing/planar.h"

namespace geargraph::inline schematic {

/// The frame behind a line: short slanted strokes on its side `out` (a unit vector).
[[nodiscard]] std::vector<std::vector<SheetPoint>> hatching(SheetPoint from, SheetPoint to, SheetPoint out);

/// An arrow around a shaft: its arc, in perspective, and the tip.
struct TurnArrow {
  Curve bow;
  std::vector<SheetPoint> tip;
};
/// `center` on the shaft, `along` its direction, `reach` the distance of the arc from the shaft on either
/// side.
[[nodiscard]] TurnArrow turnArrow(SheetPoint center, SheetPoint along, double reach);

}  // namespace geargraph::inline schematic
