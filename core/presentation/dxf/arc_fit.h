#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

namespace geargraph {

/// A corner of a curve of arcs: `bulge` is that of the piece to the next corner, the tangent of a quarter of
/// its angle, above 0 where it turns left; 0 for a line.
struct ArcVertex {
  Eigen::Vector2d at = Eigen::Vector2d::Zero();
  double bulge = 0;
};

/// The point of a piece at a part of its length, 0 to 1, and its distance from a point.
[[nodiscard]] Eigen::Vector2d pointOn(const ArcVertex& from, const Eigen::Vector2d& to, double part);

/// As few arcs and lines, end to end, as a greedy walk finds, through the first and the last point, so that
/// no point in between is farther than `tolerance` from its piece. Points that repeat are corners: pieces end
/// there. The bulge of the last vertex is 0.
/// Cost: O(points log points). @pre two different points at least, tolerance > 0
[[nodiscard]] std::vector<ArcVertex> fittedArcs(std::span<const Eigen::Vector2d> points, double tolerance);

}  // namespace geargraph
