#include "core/ttgraph/reference_lines.h"

namespace geargraph {

bool areCollinear(const AxisLine& a, const AxisLine& b) {
  const double size = 1 + length(a.point) + length(b.point);
  return areParallel(a, b) && length(cross(a.direction, b.point - a.point)) <= kSameLine * size;
}

}  // namespace geargraph
