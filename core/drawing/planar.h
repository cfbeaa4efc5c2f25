#pragma once

#include <algorithm>
#include <cmath>

#include "core/mechanism/mechanism.h"

namespace geargraph {

// Plane geometry of the sheet, x to the right, y down, units px at zoom 1.

inline SheetPoint operator+(SheetPoint a, SheetPoint b) {
  return {a.x + b.x, a.y + b.y};
}
inline SheetPoint operator-(SheetPoint a, SheetPoint b) {
  return {a.x - b.x, a.y - b.y};
}
inline SheetPoint operator*(double factor, SheetPoint p) {
  return {factor * p.x, factor * p.y};
}
inline double dot(SheetPoint a, SheetPoint b) {
  return a.x * b.x + a.y * b.y;
}
inline double length(SheetPoint p) {
  return std::sqrt(dot(p, p));  // sheets are far too small for hypot's care, which costs tenfold
}
inline double distance(SheetPoint a, SheetPoint b) {
  return length(b - a);
}
/// A quarter turn: what points to the right then points down.
inline SheetPoint turned(SheetPoint p) {
  return {-p.y, p.x};
}
/// The unit vector; (1, 0) of the zero vector.
inline SheetPoint unit(SheetPoint p) {
  const double size = length(p);
  return size > 0 ? (1 / size) * p : SheetPoint{1, 0};
}
inline SheetPoint between(SheetPoint a, SheetPoint b, double share) {
  return a + share * (b - a);
}

inline double distanceToSegment(SheetPoint p, SheetPoint from, SheetPoint to) {
  const SheetPoint along = to - from;
  const double square = dot(along, along);
  const double share = square > 0 ? std::clamp(dot(p - from, along) / square, 0.0, 1.0) : 0;
  return distance(p, from + share * along);
}

/// An upright rectangle by its centre and half its sides.
struct Extent {
  SheetPoint center;
  double halfWidth = 0;
  double halfHeight = 0;

  [[nodiscard]] Extent grown(double by) const { return {center, halfWidth + by, halfHeight + by}; }
  [[nodiscard]] double left() const { return center.x - halfWidth; }
  [[nodiscard]] double right() const { return center.x + halfWidth; }
  [[nodiscard]] double top() const { return center.y - halfHeight; }
  [[nodiscard]] double bottom() const { return center.y + halfHeight; }
  [[nodiscard]] bool contains(SheetPoint p) const {
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
  [[nodiscard]] bool meetsCircle(SheetPoint middle, double radius) const {
    const double dx = std::max(std::abs(middle.x - center.x) - halfWidth, 0.0);
    const double dy = std::max(std::abs(middle.y - center.y) - halfHeight, 0.0);
    return dx * dx + dy * dy <= radius * radius;
  }
  [[nodiscard]] bool meetsSegment(SheetPoint from, SheetPoint to) const;

  [[nodiscard]] static Extent spanning(SheetPoint a, SheetPoint b) {
    return {between(a, b, 0.5), std::abs(b.x - a.x) / 2, std::abs(b.y - a.y) / 2};
  }
  [[nodiscard]] Extent united(const Extent& other) const {
    return spanning({std::min(left(), other.left()), std::min(top(), other.top())},
                    {std::max(right(), other.right()), std::max(bottom(), other.bottom())});
  }
  friend bool operator==(const Extent&, const Extent&) = default;
};

/// A quadratic Bézier curve; a straight line if its control point is the middle.
struct Curve {
  SheetPoint from;
  SheetPoint control;
  SheetPoint to;

  [[nodiscard]] static Curve straight(SheetPoint from, SheetPoint to) {
    return {from, between(from, to, 0.5), to};
  }
  /// From one point to another, its middle `height` to the left of the straight line, seen along it on the
  /// sheet.
  [[nodiscard]] static Curve bent(SheetPoint from, SheetPoint to, double height) {
    return {from, between(from, to, 0.5) - (2 * height) * turned(unit(to - from)), to};
  }
  [[nodiscard]] bool isStraight() const { return distance(control, between(from, to, 0.5)) < 1e-6; }
  [[nodiscard]] SheetPoint at(double t) const {
    return between(between(from, control, t), between(control, to, t), t);
  }
  /// The direction of travel at t, a unit vector.
  [[nodiscard]] SheetPoint direction(double t) const {
    return unit(between(control - from, to - control, t));
  }
  /// The part from parameter t0 to t1.
  [[nodiscard]] Curve part(double t0, double t1) const;
  [[nodiscard]] Extent extent() const;
  friend bool operator==(const Curve&, const Curve&) = default;
};

/// How many chords stand for a curve where it is compared with other things.
constexpr int kCurveChords = 12;

/// Calls visit(from, to) for the chords of a curve in order: one for a straight one.
template <class Visit>
void forEachChord(const Curve& curve, Visit visit) {
  const int count = curve.isStraight() ? 1 : kCurveChords;
  SheetPoint last = curve.from;
  for (int i = 1; i <= count; ++i) {
    const SheetPoint next = curve.at(static_cast<double>(i) / count);
    visit(last, next);
    last = next;
  }
}

[[nodiscard]] double distanceToCurve(SheetPoint p, const Curve& curve);

}  // namespace geargraph
