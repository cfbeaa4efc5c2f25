#include "core/mechanism/placement/tolerance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace geargraph {
namespace {

/// Rounding below this part of a limit does not change what a decision against the limit means.
constexpr double kNegligible = 1e-3;

double hypotenuse(const Vector3& v) {  // of any size that doubles have
  return std::hypot(v[0], v[1], v[2]);
}

ExactLine exactly(const Axis& axis) {
  return {toFractions(*axis.point), toFractions(*axis.direction)};
}

/// The distance of b's point from line a, correct to the last digits.
double offsetOf(const ExactLine& a, const ExactLine& b) {
  const ExactVector3 unit = scaledToOne(a.direction);
  return hypotenuse(toDoubles(cross(unit, b.point - a.point))) / hypotenuse(toDoubles(unit));
}

}  // namespace

Vector3 exactDifference(const ExactVector3& to, const ExactVector3& from) {
  return toDoubles(to - from);
}

int LineComparison::coincidence(AxisOrdinal axis, int other) const {
  const AxisLine& a = m_lines[axis];
  const AxisLine& b = m_lines[other];
  if (!areParallel(a.direction, b.direction)) return 0;
  const int sense = dot(a.direction, b.direction) > 0 ? 1 : -1;
  const double limit = kSameLine * size();
  const double rounding = roundingOf(reachOf(a.point) + reachOf(b.point));
  const double offset = length(cross(a.direction, b.point - a.point));
  if (offset > limit + rounding) return 0;
  if (rounding <= kNegligible * limit) return offset <= limit ? sense : 0;
  return exactOffset(axis, other) <= limit ? sense : 0;
}

double LineComparison::exactOffset(AxisOrdinal axis, int other) const {
  return offsetOf(exactly(m_mechanism.axes[axis]), exactly(m_mechanism.axes[other]));
}

double LineComparison::size() const {
  if (m_size) return *m_size;
  double farthest = 0;
  for (const AxisLine& line : m_lines) farthest = std::max(farthest, reachOf(line.point));
  double size = medianDistance(false);
  if (roundingOf(2 * farthest) > kNegligible * size) size = medianDistance(true);
  m_size = size;
  return size;
}

double LineComparison::medianDistance(bool exactly) const {
  std::vector<double> distances;
  const auto axisAt = [&](LinkOrdinal link) {
    const std::span<const int> joints = m_graph.turningEdgesAt(link);
    return joints.empty() ? -1 : m_graph.axisOf()[joints.front()];
  };
  const auto measure = [&](AxisOrdinal axis, int other) {
    if (axis < 0 || other < 0 || axis == other) return;
    const AxisLine& a = m_lines[axis];
    const AxisLine& b = m_lines[other];
    if (a.automatic || b.automatic) return;
    const Vector3 apart = b.point - a.point;
    double distance = exactly
                          ? std::max(exactOffset(axis, other), exactOffset(other, axis))
                          : std::max(length(cross(a.direction, apart)), length(cross(b.direction, apart)));
    if (!exactly && distance <= roundingOf(reachOf(a.point) + reachOf(b.point))) distance = 0;
    if (distance > 0) distances.push_back(distance);
  };
  for (LinkOrdinal link = 1; link < m_graph.nodeCount(); ++link) {
    const int first = axisAt(link);
    for (const JointOrdinal joint : m_graph.turningEdgesAt(link)) measure(first, m_graph.axisOf()[joint]);
  }
  for (const DigraphEdge& mesh : m_graph.meshEdges()) {
    if (mesh.tail != 0 && mesh.head != 0) measure(axisAt(mesh.tail), axisAt(mesh.head));
  }
  if (distances.empty()) return 0;
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  return *middle;
}

LineKeys::LineKeys(SpanByAxis<const AxisLine> lines) {
  const AxisLine* first = nullptr;
  double extent = 0;
  for (const AxisLine& line : lines) {
    if (line.automatic) continue;
    if (first == nullptr) {
      first = &line;
      origin = line.point;
    }
    extent = std::max(extent, reachOf(line.point - origin));
  }
  if (extent > 0) scale = 1 / extent;
  if (!std::isfinite(scale)) scale = 0;
  constexpr double kParts = 16;  // of what coincidence() lets pass: directions, places, and feet that tilt
  window = kParts * kSameLine + roundingOf(kParts * (reachOf(origin) + extent)) * scale;
}

double LineKeys::of(const AxisLine& line, const Vector3& weights) const {
  if (line.automatic) return std::numeric_limits<double>::infinity();
  const Vector3 from = line.point - origin;
  const Vector3 foot = from - dot(from, line.direction) * line.direction;
  const double seen = dot(line.direction, weights);
  return scale * dot(foot, weights) + seen * seen;
}

}  // namespace geargraph
