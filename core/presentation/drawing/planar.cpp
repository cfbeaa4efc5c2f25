#include "core/presentation/drawing/planar.h"

#include <limits>

namespace geargraph {

bool Extent::meetsSegment(CanvasPoint from, CanvasPoint to) const {
  // Liang and Barsky: the share of the segment that lies between each pair of parallel sides.
  double enter = 0;
  double leave = 1;
  const auto clip = [&](double start, double step, double low, double high) {
    if (step == 0) return start >= low && start <= high;
    double a = (low - start) / step;
    double b = (high - start) / step;
    if (a > b) std::swap(a, b);
    enter = std::max(enter, a);
    leave = std::min(leave, b);
    return enter <= leave;
  };
  return clip(from.x, to.x - from.x, left(), right()) && clip(from.y, to.y - from.y, top(), bottom());
}

Extent Curve::extent() const {
  Extent box = Extent::spanning(from, to);
  if (isStraight()) return box;
  forEachChord(*this, [&](CanvasPoint, CanvasPoint p) { box = box.united(Extent{p, 0, 0}); });
  return box;
}

double distanceToCurve(CanvasPoint p, const Curve& curve) {
  double nearest = std::numeric_limits<double>::infinity();
  forEachChord(curve, [&](CanvasPoint from, CanvasPoint to) {
    nearest = std::min(nearest, distanceToSegment(p, from, to));
  });
  return nearest;
}

}  // namespace geargraph
