#include "core/presentation/dxf/arc_fit.h"

#include <algorithm>
#include <cmath>

#include "core/foundations/base/contract.h"

namespace geargraph {
namespace {

using Eigen::Vector2d;

double crossOf(const Vector2d& a, const Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// A piece from one point to another: a circle's arc, or the chord itself.
struct Piece {
  Vector2d from;
  Vector2d to;
  double bulge = 0;
  Vector2d center = Vector2d::Zero();
  double radius = 0;  ///< 0: the chord

  [[nodiscard]] double distance(const Vector2d& point) const {
    if (radius > 0) return std::abs((point - center).norm() - radius);
    const Vector2d along = to - from;
    return std::abs(crossOf(along, point - from)) / along.norm();
  }
};

/// The arc through three points; the chord where they are on a line.
Piece pieceThrough(const Vector2d& from, const Vector2d& middle, const Vector2d& to) {
  constexpr double kFlat = 1e-9;  // sagitta over chord: the arc differs from the chord by rounding only
  Piece piece{from, to};
  const Vector2d chord = to - from;
  const Vector2d half = middle - from;
  const double area = crossOf(half, chord);  // above 0: the middle is on the right, the arc turns left
  if (std::abs(area) <= kFlat * chord.squaredNorm()) return piece;
  const double twice = 2 * crossOf(half, chord);
  const double a = half.squaredNorm();
  const double c = chord.squaredNorm();
  piece.center = from + Vector2d(chord.y() * a - half.y() * c, half.x() * c - chord.x() * a) / twice;
  piece.radius = (piece.center - from).norm();
  const Vector2d right(chord.y(), -chord.x());
  const double side = area > 0 ? 1 : -1;
  // The sagitta: from the chord's middle to the arc, on the side of the middle point.
  const double toCenter = (piece.center - (from + to) / 2).dot(side * right.normalized());
  const double sagitta = piece.radius + toCenter;
  piece.bulge = side * 2 * sagitta / chord.norm();
  return piece;
}

/// The piece over these points, if it is within the tolerance of all of them.
bool fits(std::span<const Vector2d> points, std::size_t first, std::size_t last, double tolerance,
          Piece& piece) {
  piece = pieceThrough(points[first], points[(first + last) / 2], points[last]);
  if (last == first + 1) piece = Piece{points[first], points[last]};
  for (std::size_t i = first + 1; i < last; ++i) {
    if (piece.distance(points[i]) > tolerance) return false;
  }
  return true;
}

}  // namespace

Eigen::Vector2d pointOn(const ArcVertex& from, const Eigen::Vector2d& to, double part) {
  const Vector2d chord = to - from.at;
  if (from.bulge == 0) return from.at + part * chord;
  const double angle = 4 * std::atan(from.bulge);
  const Vector2d left(-chord.y(), chord.x());
  const Vector2d center = from.at + chord / 2 + left / (2 * std::tan(angle / 2));
  const Vector2d radius = from.at - center;
  const double turned = part * angle;
  return center + Vector2d(radius.x() * std::cos(turned) - radius.y() * std::sin(turned),
                           radius.x() * std::sin(turned) + radius.y() * std::cos(turned));
}

std::vector<ArcVertex> fittedArcs(std::span<const Eigen::Vector2d> points, double tolerance) {
  GEARGRAPH_REQUIRE(points.size() >= 2 && tolerance > 0);
  std::vector<ArcVertex> vertices;
  std::size_t first = 0;
  while (first + 1 < points.size()) {
    if (points[first] == points[first + 1]) {  // a corner
      ++first;
      continue;
    }
    std::size_t corner = first + 1;
    while (corner + 1 < points.size() && points[corner] != points[corner + 1]) ++corner;
    Piece best;
    std::size_t last = first + 1;
    fits(points, first, last, tolerance, best);
    // Gallop, then halve: where a longer piece fits is found without trying every length.
    std::size_t step = 1;
    while (last + step <= corner) {
      Piece longer;
      if (!fits(points, first, last + step, tolerance, longer)) break;
      last += step;
      best = longer;
      step *= 2;
    }
    for (; step > 0; step /= 2) {
      Piece longer;
      if (last + step > corner || !fits(points, first, last + step, tolerance, longer)) continue;
      last += step;
      best = longer;
    }
    vertices.push_back({points[first], best.bulge});
    first = last;
  }
  vertices.push_back({points.back(), 0});
  return vertices;
}

}  // namespace geargraph
