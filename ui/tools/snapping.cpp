#include "ui/tools/snapping.h"

#include <cmath>

namespace geargraph {
namespace {

/// Keeps the smaller correction that brings `from` to `to`.
void consider(double from, double to, double reach, std::optional<double>& line, double& correction) {
  const double wanted = to - from;
  if (std::abs(wanted) > reach || (line && std::abs(wanted) >= std::abs(correction))) return;
  line = to;
  correction = wanted;
}

}  // namespace

Snap snapped(std::span<const SheetPoint> moving, std::span<const SheetPoint> resting, double dx, double dy,
             double reach) {
  Snap snap{dx, dy, {}, {}};
  double pullX = 0;
  double pullY = 0;
  for (const SheetPoint& node : moving) {
    for (const SheetPoint& other : resting) {
      consider(node.x + dx, other.x, reach, snap.column, pullX);
      consider(node.y + dy, other.y, reach, snap.row, pullY);
    }
  }
  snap.dx += pullX;
  snap.dy += pullY;
  return snap;
}

SheetPoint onGrid(SheetPoint point, double step) {
  return {step * std::round(point.x / step), step * std::round(point.y / step)};
}

}  // namespace geargraph
