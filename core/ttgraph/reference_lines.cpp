#include "core/ttgraph/reference_lines.h"

#include "core/placement/tolerance.h"

namespace geargraph {

ReferenceLines referenceLines(const Placement& placement) {
  ReferenceLines lines;
  lines.axes.reserve(placement.axes.size());
  for (const AxisLine& axis : placement.axes) {
    lines.axes.push_back(ReferenceLine{axis.point, axis.direction, axis.automatic});
  }
  lines.pitchPoints.reserve(placement.meshes.size());
  for (const std::optional<MeshGeometry>& mesh : placement.meshes) {
    lines.pitchPoints.push_back(mesh ? std::optional(mesh->pitchPoint) : std::nullopt);
  }
  return lines;
}

bool areParallel(const ReferenceLine& a, const ReferenceLine& b) {
  return length(cross(a.direction, b.direction)) <= kSameLine;
}

bool areCollinear(const ReferenceLine& a, const ReferenceLine& b) {
  const double size = 1 + length(a.point) + length(b.point);
  return areParallel(a, b) && length(cross(a.direction, b.point - a.point)) <= kSameLine * size;
}

}  // namespace geargraph
