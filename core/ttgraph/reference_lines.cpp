#include "core/ttgraph/reference_lines.h"

#include "core/placement/tolerance.h"

namespace geargraph {

ReferenceLines referenceLines(const Placement& placement) {
  ReferenceLines lines;
  lines.axes.assign(placement.axes.begin(), placement.axes.end());
  lines.pitchPoints.reserve(placement.meshes.size());
  for (const std::optional<MeshGeometry>& mesh : placement.meshes) {
    lines.pitchPoints.push_back(mesh ? std::optional(mesh->pitchPoint) : std::nullopt);
  }
  return lines;
}

bool areParallel(const AxisLine& a, const AxisLine& b) {
  return length(cross(a.direction, b.direction)) <= kSameLine;
}

bool areCollinear(const AxisLine& a, const AxisLine& b) {
  const double size = 1 + length(a.point) + length(b.point);
  return areParallel(a, b) && length(cross(a.direction, b.point - a.point)) <= kSameLine * size;
}

}  // namespace geargraph
