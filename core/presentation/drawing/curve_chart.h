#pragma once

#include <string>
#include <vector>

#include "core/presentation/drawing/display_list.h"

namespace geargraph {

/// A curve through points, in the order of their x.
struct ChartCurve {
  std::string name;
  std::vector<CanvasPoint> points;
};

/// Curves over one quantity, from 0 on both axes.
struct CurveChart {
  std::string title;
  std::string xTitle;
  std::vector<ChartCurve> curves;  ///< at most kMaxChartCurves
};

constexpr std::size_t kMaxChartCurves = 4;

/// Charts side by side, with axes, round numbers at their ticks, a mark at each point (of a different shape
/// for each curve, so that curves are distinguishable without colours), and one legend for the names of all.
/// @pre all charts have curves of the same names; no value is negative
[[nodiscard]] DisplayList chartDrawing(const std::vector<CurveChart>& charts);

/// The smallest of 1, 2, 5 times a power of ten that divides 0 to `most` into at most `parts` parts.
/// @pre most > 0, parts > 0
[[nodiscard]] double tickStep(double most, int parts);

}  // namespace geargraph
