#include "core/ttgraph/reference_lines.h"

#include <cmath>

namespace geargraph {
namespace {

// Coordinates are typed as decimals, so lines that are meant to be one may differ in the last digits. This
// decides which joints are coaxial; no rank and no zero ever comes from it.
constexpr double kCloseness = 1e-9;

Triple valuesOf(const NumberTriple& triple) {
  return {triple[0].value(), triple[1].value(), triple[2].value()};
}

}  // namespace

ReferenceLines drawnLines(const Mechanism& mechanism) {
  ReferenceLines lines;
  lines.axes.reserve(mechanism.axes.size());
  for (const Axis& axis : mechanism.axes) {
    std::optional<AxisLine>& line = lines.axes.emplace_back();
    if (!axis.point || !axis.direction) continue;
    line = AxisLine{valuesOf(*axis.point), valuesOf(*axis.direction)};
    const double size = length(line->direction);
    for (double& component : line->direction) component /= size;
  }
  lines.pitchPoints.reserve(mechanism.gearMeshes.size());
  for (const GearMesh& mesh : mechanism.gearMeshes) {
    std::optional<Triple>& point = lines.pitchPoints.emplace_back();
    if (mesh.pitchPoint) point = valuesOf(*mesh.pitchPoint);
  }
  return lines;
}

Triple difference(const Triple& a, const Triple& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

double dot(const Triple& a, const Triple& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Triple cross(const Triple& a, const Triple& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double length(const Triple& a) {
  return std::hypot(a[0], a[1], a[2]);
}

bool areParallel(const AxisLine& a, const AxisLine& b) {
  return length(cross(a.direction, b.direction)) <= kCloseness;
}

bool areCollinear(const AxisLine& a, const AxisLine& b, double size) {
  return areParallel(a, b) && length(cross(difference(b.point, a.point), a.direction)) <= kCloseness * size;
}

}  // namespace geargraph
