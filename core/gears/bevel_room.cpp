#include "core/gears/bevel_room.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/gears/bodies.h"
#include "core/gears/gear_body.h"
#include "core/placement/tolerance.h"

namespace geargraph {
namespace {

/// (radius, coordinate along the first wheel's axis), a closed polygon.
using Outline = std::vector<Eigen::Vector2d>;

Outline outlineOf(const TrainWheel& wheel, const TrainWheel& along) {
  const double origin = (wheel.origin - along.origin).dot(along.axis);
  const double sense = wheel.axis.dot(along.axis);
  Outline outline;
  for (const ProfileVertex& c : bevelOutline(wheel.spec))
    outline.emplace_back(c.radius, origin + sense * c.height);
  return outline;
}

double side(const Eigen::Vector2d& from, const Eigen::Vector2d& to, const Eigen::Vector2d& p) {
  const Eigen::Vector2d way = to - from, out = p - from;
  return way.x() * out.y() - way.y() * out.x();
}

template <class Visit>
bool anyEdge(const Outline& outline, Visit visit) {
  for (std::size_t i = 0; i < outline.size(); ++i) {
    if (visit(outline[i], outline[(i + 1) % outline.size()])) return true;
  }
  return false;
}

bool cross(const Outline& a, const Outline& b) {
  return anyEdge(a, [&](const Eigen::Vector2d& p, const Eigen::Vector2d& q) {
    return anyEdge(b, [&](const Eigen::Vector2d& r, const Eigen::Vector2d& s) {
      return side(p, q, r) * side(p, q, s) < 0 && side(r, s, p) * side(r, s, q) < 0;
    });
  });
}

bool holds(const Outline& outline, const Eigen::Vector2d& p) {
  bool inside = false;
  anyEdge(outline, [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    const bool between = (a.y() > p.y()) != (b.y() > p.y());
    if (between && p.x() < a.x() + (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y())) inside = !inside;
    return false;
  });
  return inside;
}

/// A point of its own: the middle of the outline's teeth.
Eigen::Vector2d within(const Outline& outline) {
  return (outline.front() + outline.back() + outline[outline.size() - 2]) / 3;
}

constexpr double kPace = 0.7;     // modules between the points that are looked at
constexpr double kUnseen = 0.15;  // modules by which wheels may lie in each other
constexpr int kMostTurns = 1500;  // points of a circle; a wheel of 330 teeth has as many at that pace
constexpr int kMostPieces = 250;  // of an edge of the outline

/// How deep a point lies within the outline: its distance from the nearest edge, below 0 outside. It changes
/// by no more than the way between two points of space.
double depthIn(const Outline& outline, const Eigen::Vector2d& p) {
  double nearest = 1e300;
  anyEdge(outline, [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    if (a.x() == 0 && b.x() == 0) return false;  // the axis is no surface
    const Eigen::Vector2d way = b - a;
    const double share = std::clamp((p - a).dot(way) / std::max(way.squaredNorm(), 1e-300), 0.0, 1.0);
    nearest = std::min(nearest, (p - a - share * way).norm());
    return false;
  });
  return holds(outline, p) ? nearest : -nearest;
}

int piecesOf(double length, double pace, int fewest, int most) {
  return static_cast<int>(std::clamp(std::ceil(length / pace), double(fewest), double(most)));
}

/// Does a point of one wheel's surface lie in the other? A point outside of it tells how far the next ones
/// are outside, too: of a circle that stays clear only few are looked at.
bool reachesInto(const TrainWheel& wheel, const TrainWheel& other) {
  const Outline own = outlineOf(wheel, wheel), its = outlineOf(other, other);
  const Eigen::Isometry3d frame = frameAlong(wheel.origin, wheel.axis);
  const double pace = kPace * wheel.spec.module;
  const double deep = kUnseen * other.spec.module;
  const auto isIn = [&](const Eigen::Vector2d& p) {
    const double circle = 2 * std::numbers::pi * std::abs(p.x());
    const int turns = piecesOf(circle, pace, 8, kMostTurns);
    for (int i = 0; i < turns;) {
      const double angle = 2 * std::numbers::pi * i / turns;
      const Eigen::Vector3d at =
          frame * Eigen::Vector3d(p.x() * std::cos(angle), p.x() * std::sin(angle), p.y()) - other.origin;
      const double along = at.dot(other.axis);
      const double missing = deep - depthIn(its, {(at - along * other.axis).norm(), along});
      if (missing < 0) return true;
      const double passed = std::floor(missing * turns / std::max(circle, 1e-300));
      i += 1 + static_cast<int>(std::min(passed, double(turns)));
    }
    return false;
  };
  return anyEdge(own, [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    const int pieces = piecesOf((b - a).norm(), pace, 1, kMostPieces);
    for (int i = 0; i < pieces; ++i) {
      if (isIn(a + (b - a) * i / pieces)) return true;
    }
    return false;
  });
}

}  // namespace

bool bevelsCross(const TrainWheel& a, const TrainWheel& b) {
  return reachesInto(a, b) || reachesInto(b, a);
}

bool bevelsCollide(const TrainWheel& a, const TrainWheel& b) {
  const Eigen::Vector3d apart = b.origin - a.origin;
  const bool oneLine = std::abs(std::abs(a.axis.dot(b.axis)) - 1) < 1e-12 &&
                       (apart - apart.dot(a.axis) * a.axis).norm() <= kSameLine * a.workingRadius;
  if (!oneLine) return false;
  const Outline first = outlineOf(a, a), second = outlineOf(b, a);
  return cross(first, second) || holds(first, within(second)) || holds(second, within(first));
}

}  // namespace geargraph
