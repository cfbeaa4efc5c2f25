#pragma once

#include <algorithm>
#include <cmath>

#include "core/mechanism/model/mechanism.h"

namespace geargraph {

// Plane geometry of the sheet, x to the right, y down, units px at zoom 1.

inline CanvasPoint operator+(CanvasPoint a, CanvasPoint b) {
  return {a.x + b.x, a.y + b.y};
}
inline CanvasPoint operator-(CanvasPoint a, CanvasPoint b) {
  return {a.x - b.x, a.y - b.y};
}
inline CanvasPoint operator*(double factor, CanvasPoint p) {
  return {factor * p.x, factor * p.y};
}
inline double dot(CanvasPoint a, CanvasPoint b) {
  return a.x * b.x + a.y * b.y;
}
inline double length(CanvasPoint p) {
  return std::sqrt(dot(p, p));  // sheets are far too small for hypot's care, which costs tenfold
}
inline double distance(CanvasPoint a, CanvasPoint b) {
  return length(b - a);
}
/// A quarter turn: what points to the right then points down.
inline CanvasPoint turned(CanvasPoint p) {
  return {-p.y, p.x};
}
/// The unit vector; (1, 0) of the zero vector.
inline CanvasPoint unit(CanvasPoint p) {
  const double size = length(p);
  return size > 0 ? (1 / size) * p : CanvasPoint{1, 0};
}
inline CanvasPoint between(CanvasPoint a, CanvasPoint b, double share) {
  return a + share * (b - a);
}

inline double distanceToSegment(CanvasPoint p, CanvasPoint from, CanvasPoint to) {
  const CanvasPoint along = to - from;
  const double square = dot(along, along);
  const double share = square > 0 ? std::clamp(dot(p - from, along) / square, 0.0, 1.0) : 0;
  return distance(p, from + share * along);
}

/// An upright rectangle by its centre and half its sides.
struct Extent {
  CanvasPoint center;
  double halfWidth = 0;
  double halfHeight = 0;

  [[nodiscard]] Extent grown(double by) const { return {center, halfWidth + by, halfHeight + by}; }
  [[nodiscard]] double left() const { return center.x - halfWidth; }
  [[nodiscard]] double right() const { return center.x + halfWidth; }
  [[nodiscard]] double top() const { return center.y - halfHeight; }
  [[nodiscard]] double bottom() const { return center.y + halfHeight; }
  [[nodiscard]] bool contains(CanvasPoint p) const {
    return std::abs(p.x - center.x) <= halfWidth && std::abs(p.y - center.y) <= halfHeight;
  }
  [[nodiscard]] bool contains(const Extent& inner) const {
    return inner.left() >= left() && inner.right() <= right() && inner.top() >= top() &&
           inner.bottom() <= bottom();
  }
  [[nodiscard]] bool meets(const Extent& other) const {
    return std::abs(center.x - other.center.x) <= halfWidth + other.halfWidth &&
           std::abs(center.y - other.center.y) <= halfHeight + other.halfHeight;
  }
  [[nodiscard]] bool meetsCircle(CanvasPoint middle, double radius) const {
    const double dx = std::max(std::abs(middle.x - center.x) - halfWidth, 0.0);
    const double dy = std::max(std::abs(middle.y - center.y) - halfHeight, 0.0);
    return dx * dx + dy * dy <= radius * radius;
  }
  [[nodiscard]] bool meetsSegment(CanvasPoint from, CanvasPoint to) const;

  [[nodiscard]] static Extent spanning(CanvasPoint a, CanvasPoint b) {
    return {between(a, b, 0.5), std::abs(b.x - a.x) / 2, std::abs(b.y - a.y) / 2};
  }
  [[nodiscard]] Extent united(const Extent& other) const {
    return spanning({std::min(left(), other.left()), std::min(top(), other.top())},
                    {std::max(right(), other.right()), std::max(bottom(), other.bottom())});
  }
  friend bool operator==(const Extent&, const Extent&) = default;
};

/// A cubic Bézier curve; a straight line if its control points are at the thirds of it.
struct Curve {
  CanvasPoint from;
  CanvasPoint leaving;   ///< the control point of the start
  CanvasPoint arriving;  ///< that of the end
  CanvasPoint to;

  [[nodiscard]] static Curve straight(CanvasPoint from, CanvasPoint to) {
    return {from, between(from, to, 1.0 / 3), between(from, to, 2.0 / 3), to};
  }
  /// From one point to another, displaced to the left of the straight line (seen along it on the sheet) by
  /// `first` and `second` at its thirds. Equal values give an arc whose middle is that far off the line;
  /// opposite ones give an S.
  [[nodiscard]] static Curve pulled(CanvasPoint from, CanvasPoint to, double first, double second) {
    constexpr double kToControl = 4.0 / 3;  // a bow's control points lie farther out than its middle
    const CanvasPoint left = (-kToControl) * turned(unit(to - from));
    return {from, between(from, to, 1.0 / 3) + first * left, between(from, to, 2.0 / 3) + second * left, to};
  }
  [[nodiscard]] bool isStraight() const {
    return distance(leaving, between(from, to, 1.0 / 3)) < 1e-6 &&
           distance(arriving, between(from, to, 2.0 / 3)) < 1e-6;
  }
  [[nodiscard]] CanvasPoint at(double t) const { return blossom(t, t, t); }
  /// The direction of travel at t, a unit vector.
  [[nodiscard]] CanvasPoint direction(double t) const {
    const CanvasPoint start = between(leaving - from, arriving - leaving, t);
    const CanvasPoint end = between(arriving - leaving, to - arriving, t);
    return unit(between(start, end, t));
  }
  /// The part from parameter t0 to t1.
  [[nodiscard]] Curve part(double t0, double t1) const {
    return {at(t0), blossom(t0, t0, t1), blossom(t0, t1, t1), at(t1)};
  }
  [[nodiscard]] Extent extent() const;
  friend bool operator==(const Curve&, const Curve&) = default;

 private:
  /// de Casteljau's algorithm with a separate parameter in every step (polar form).
  [[nodiscard]] CanvasPoint blossom(double u, double v, double w) const {
    const CanvasPoint a = between(from, leaving, u);
    const CanvasPoint b = between(leaving, arriving, u);
    const CanvasPoint c = between(arriving, to, u);
    return between(between(a, b, v), between(b, c, v), w);
  }
};

/// The number of chords that approximate a curve in distance and collision tests.
constexpr int kCurveChords = 14;

/// Calls visit(from, to) for the chords of a curve in order; one chord for a straight curve.
template <class Visit>
void forEachChord(const Curve& curve, Visit visit) {
  const int count = curve.isStraight() ? 1 : kCurveChords;
  CanvasPoint last = curve.from;
  for (int i = 1; i <= count; ++i) {
    const CanvasPoint next = curve.at(static_cast<double>(i) / count);
    visit(last, next);
    last = next;
  }
}

[[nodiscard]] double distanceToCurve(CanvasPoint p, const Curve& curve);

}  // namespace geargraph
