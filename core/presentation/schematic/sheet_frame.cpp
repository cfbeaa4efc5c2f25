#include "core/presentation/schematic/sheet_frame.h"

#include <algorithm>

namespace geargraph {
namespace {

/// Between stops in proportion, beyond them at the scale.
double coordinateAt(const std::vector<std::pair<double, double>>& stops, double x, double scale) {
  if (x <= stops.front().first) return stops.front().second + (x - stops.front().first) / scale;
  for (std::size_t i = 1; i < stops.size(); ++i) {
    const auto& [fromX, from] = stops[i - 1];
    const auto& [toX, to] = stops[i];
    if (x <= toX) return from + (to - from) * (x - fromX) / (toX - fromX);
  }
  return stops.back().second + (x - stops.back().first) / scale;
}

}  // namespace

Vector3 CanvasFrame::spaceOf(CanvasPoint p) const {
  const CanvasPoint from = p - origin;
  const double along = stops.empty() ? from.x / scale : coordinateAt(stops, p.x, scale);
  return base + along * right + (-from.y / scale) * up;
}

const CanvasFrame::Line* CanvasFrame::axisNear(CanvasPoint p, double reach) const {
  const Line* nearest = nullptr;
  for (const Line& line : axes) {
    const double away = std::abs(dot(p - line.at, turned(line.along)));
    if (away > reach) continue;
    reach = away;
    nearest = &line;
  }
  return nearest;
}

const CanvasFrame::Line* CanvasFrame::line(AxisId axis) const {
  const auto found = std::find_if(axes.begin(), axes.end(), [&](const Line& l) { return l.axis == axis; });
  return found == axes.end() ? nullptr : &*found;
}

}  // namespace geargraph
