#include "core/presentation/drawing/hit_test.h"

#include <limits>
#include <unordered_set>

namespace geargraph {
namespace {

/// How far a point is from a shape, 0 inside.
struct DistanceTo {
  CanvasPoint point;

  double operator()(const Circle& circle) const {
    return std::max(distance(point, circle.center) - circle.radius, 0.0);
  }
  double operator()(const Box& box) const {
    const double dx = std::max(std::abs(point.x - box.extent.center.x) - box.extent.halfWidth, 0.0);
    const double dy = std::max(std::abs(point.y - box.extent.center.y) - box.extent.halfHeight, 0.0);
    return std::hypot(dx, dy);
  }
  double operator()(const Polyline& line) const {
    double nearest = std::numeric_limits<double>::infinity();
    const std::size_t count = line.points.size();
    for (std::size_t i = line.closed ? 0 : 1; i < count; ++i) {
      nearest =
          std::min(nearest, distanceToSegment(point, line.points[(i + count - 1) % count], line.points[i]));
    }
    return nearest;
  }
  double operator()(const Curve& curve) const { return distanceToCurve(point, curve); }
};

}  // namespace

std::optional<ElementId> elementAt(const std::vector<Outline>& outlines, CanvasPoint point, double reach) {
  const Outline* best = nullptr;
  double nearest = 0;
  for (const Outline& outline : outlines) {
    if (best != nullptr && outline.z < best->z) continue;
    const double limit = outline.halfWidth + reach;
    if (!extentOf(outline.shape).grown(limit).contains(point)) continue;
    const double away = std::visit(DistanceTo{point}, outline.shape);
    if (away > limit || (best != nullptr && outline.z == best->z && away >= nearest)) continue;
    best = &outline;
    nearest = away;
  }
  if (best == nullptr) return std::nullopt;
  return best->element;
}

std::vector<ElementId> elementsInside(const std::vector<Outline>& outlines, const Extent& area) {
  std::unordered_set<ElementId> outside;
  for (const Outline& outline : outlines) {
    if (!area.contains(extentOf(outline.shape))) outside.insert(outline.element);
  }
  std::vector<ElementId> inside;
  for (const Outline& outline : outlines) {
    if (outside.insert(outline.element).second) inside.push_back(outline.element);
  }
  return inside;
}

}  // namespace geargraph
