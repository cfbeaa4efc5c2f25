#include "core/ttgraph/reference_lines.h"

#include "core/placement/tolerance.h"

namespace geargraph {

bool areParallel(const AxisLine& a, const AxisLine& b) {
  const Vector3 normal = cross(a.direction, b.direction);
  return dot(normal, normal) <= kSameLine * kSameLine;
}

bool areCollinear(const AxisLine& a, const AxisLine& b) {
  const double size = 1 + length(a.point) + length(b.point);
  return areParallel(a, b) && length(cross(a.direction, b.point - a.point)) <= kSameLine * size;
}

}  // namespace geargraph
