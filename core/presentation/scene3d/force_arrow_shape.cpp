#include "core/presentation/scene3d/force_arrow_shape.h"

#include <algorithm>

namespace geargraph {
namespace {

constexpr double kShortestArrow = 6;     // px: all of it is head
constexpr double kArrowHead = 13;        // px, at most
constexpr double kArrowHeadShare = 0.6;  // of the length of a shorter arrow
constexpr double kArrowSlimness = 0.42;  // half of the width of a head over its length

}  // namespace

ForceArrowShape forceArrowShape(const ForceArrow& arrow, const LabelGround& ground) {
  ForceArrowShape shape;
  shape.from = ground.project(arrow.from);
  const Eigen::Vector2d tip = ground.project(arrow.to);
  const double length = (tip - shape.from).norm();
  shape.isDisc = length < kShortestArrow;
  if (shape.isDisc) {
    shape.neck = shape.from;
    shape.head.fill(shape.from);
    return shape;
  }
  const Eigen::Vector2d way = (tip - shape.from) / length;
  const double head = std::clamp(kArrowHeadShare * length, kShortestArrow, kArrowHead);
  const Eigen::Vector2d wing = kArrowSlimness * head * Eigen::Vector2d(-way.y(), way.x());
  shape.neck = tip - head * way;
  shape.head = {tip, shape.neck + wing, shape.neck - wing};
  return shape;
}

}  // namespace geargraph
