#include "ui/tools/snapping.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

namespace geargraph {
namespace {

/// The line that moved nodes are pulled onto, and how far.
struct Pull {
  std::optional<double> line;
  double correction = 0;

  void consider(double from, double to, double reach) {
    const double wanted = to - from;
    if (std::abs(wanted) > reach || (line && std::abs(wanted) >= std::abs(correction))) return;
    line = to;
    correction = wanted;
  }
};

/// Of all pairs of a moved and a resting node, the least correction in one coordinate: only the neighbours of
/// a node among the sorted lines can give it.
Pull nearestLine(std::span<const CanvasPoint> moving, std::span<const CanvasPoint> resting,
                 double CanvasPoint::*coordinate, double shift, double reach) {
  std::vector<double> lines;
  lines.reserve(resting.size());
  for (const CanvasPoint& node : resting) lines.push_back(node.*coordinate);
  std::sort(lines.begin(), lines.end());
  Pull pull;
  for (const CanvasPoint& node : moving) {
    const double at = node.*coordinate + shift;
    const auto next = std::lower_bound(lines.begin(), lines.end(), at);
    if (next != lines.end()) pull.consider(at, *next, reach);
    if (next != lines.begin()) pull.consider(at, *std::prev(next), reach);
  }
  return pull;
}

}  // namespace

Snap snapped(std::span<const CanvasPoint> moving, std::span<const CanvasPoint> resting, double dx, double dy,
             double reach) {
  const Pull toColumn = nearestLine(moving, resting, &CanvasPoint::x, dx, reach);
  const Pull toRow = nearestLine(moving, resting, &CanvasPoint::y, dy, reach);
  return {dx + toColumn.correction, dy + toRow.correction, toColumn.line, toRow.line};
}

CanvasPoint onGrid(CanvasPoint point, double step) {
  return {step * std::round(point.x / step), step * std::round(point.y / step)};
}

}  // namespace geargraph
