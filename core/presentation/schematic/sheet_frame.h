#pragma once

#include <optional>
#include <vector>

#include "core/foundations/base/id.h"
#include "core/foundations/base/triple.h"
#include "core/presentation/drawing/planar.h"

namespace geargraph {

/// The frame of a sheet in space, which maps points of the sheet to the mechanism. The default is the sheet
/// of a mechanism without axes, whose first axis will be horizontal.
struct CanvasFrame {
  Vector3 base{};
  Vector3 right{0, 0, 1};  ///< unit vectors in space: right and up on the sheet
  Vector3 up{1, 0, 0};
  CanvasPoint origin;  ///< the point of the sheet for `base`
  double scale = 3;    ///< px per unit of length
  /// The map along a sheet that is not to scale: (px to the right, coordinate), ascending in both; empty if
  /// it is to scale.
  std::vector<std::pair<double, double>> stops;

  struct Line {
    AxisId axis;
    CanvasPoint at;
    CanvasPoint along;
  };
  std::vector<Line> axes;

  [[nodiscard]] Vector3 spaceOf(CanvasPoint p) const;
  /// The axis whose line is nearest to a point, if within `reach`; else null.
  [[nodiscard]] const Line* axisNear(CanvasPoint p, double reach) const;
  [[nodiscard]] const Line* line(AxisId axis) const;
};

}  // namespace geargraph
