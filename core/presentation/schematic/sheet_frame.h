#pragma once

#include <optional>
#include <vector>

#include "core/foundations/base/id.h"
#include "core/foundations/base/triple.h"
#include "core/presentation/drawing/planar.h"

namespace geargraph::inline schematic {

/// How a sheet lies in space: what a place on it means for the mechanism that is drawn there. As it stands it
/// is the sheet of a mechanism without axes: the first one will be horizontal.
struct SheetFrame {
  Vector3 base{};
  Vector3 right{0, 0, 1};  ///< unit vectors: what lies to the right and what upward
  Vector3 up{1, 0, 0};
  SheetPoint origin;  ///< where `base` lies
  double scale = 3;   ///< px a unit of length
  /// Where along the sheet is not to scale: (px to the right, coordinate), ascending in both; empty where it
  /// is.
  std::vector<std::pair<double, double>> stops;

  struct Line {
    AxisId axis;
    SheetPoint at;
    SheetPoint along;
  };
  std::vector<Line> axes;

  [[nodiscard]] Vector3 spaceOf(SheetPoint p) const;
  /// The axis whose line comes nearest to a place, if that is at most `reach` away.
  [[nodiscard]] const Line* axisNear(SheetPoint p, double reach) const;
  [[nodiscard]] const Line* line(AxisId axis) const;
};

}  // namespace geargraph::inline schematic
