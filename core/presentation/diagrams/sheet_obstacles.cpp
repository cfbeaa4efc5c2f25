#include "core/presentation/diagrams/sheet_obstacles.h"

namespace geargraph {
namespace {

constexpr double kWide = 4;  ///< px: from here on the edges of a line count, too

void addEdges(ObstacleGrid& taken, const Stroke& stroke) {
  const auto* line = std::get_if<Polyline>(&stroke.shape);
  if (line == nullptr) return;
  for (std::size_t i = 1; i < line->points.size(); ++i) {
    const CanvasPoint from = line->points[i - 1];
    const CanvasPoint to = line->points[i];
    const CanvasPoint aside = stroke.width / 2 * turned(unit(to - from));
    for (const double side : {1.0, -1.0})
      taken.addCurve(Curve::straight(from + side * aside, to + side * aside));
  }
}

}  // namespace

void addObstacles(ObstacleGrid& taken, const Shape& shape) {
  if (const auto* line = std::get_if<Polyline>(&shape)) {
    for (std::size_t i = 1; i < line->points.size(); ++i)
      taken.addCurve(Curve::straight(line->points[i - 1], line->points[i]));
    if (line->closed) taken.addCurve(Curve::straight(line->points.back(), line->points.front()));
  } else if (const auto* curve = std::get_if<Curve>(&shape)) {
    taken.addCurve(*curve);
  } else {
    taken.addBox(extentOf(shape));
  }
}

void addObstacles(ObstacleGrid& taken, const DisplayList& drawing) {
  for (const Mark& mark : drawing.marks) {
    if (const auto* stroke = std::get_if<Stroke>(&mark.what)) {
      addObstacles(taken, stroke->shape);
      if (stroke->width > kWide) addEdges(taken, *stroke);
    }
    if (const auto* fill = std::get_if<Fill>(&mark.what)) addObstacles(taken, fill->shape);
    if (std::holds_alternative<Text>(mark.what)) taken.addBox(extentOf(mark));
  }
}

}  // namespace geargraph
