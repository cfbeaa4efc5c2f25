#include "core/gears/bevel_room.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/gears/bodies.h"
#include "core/gears/gear_body.h"

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

/// Does a point lie within the outline, farther than so much from its edges?
bool holdsDeep(const Outline& outline, const Eigen::Vector2d& p, double depth) {
  return holds(outline, p) && !anyEdge(outline, [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
           const Eigen::Vector2d way = b - a;
           if (a.x() == 0 && b.x() == 0) return false;  // the axis is no surface
           const double share = std::clamp((p - a).dot(way) / std::max(way.squaredNorm(), 1e-300), 0.0, 1.0);
           return (p - a - share * way).norm() <= depth;
         });
}

/// Does a point of one wheel's surface lie in the other?
bool reachesInto(const TrainWheel& wheel, const TrainWheel& other) {
  const Outline own = outlineOf(wheel, wheel), its = outlineOf(other, other);
  const Eigen::Isometry3d frame = frameAlong(wheel.origin, wheel.axis);
  const double pace = kPace * wheel.spec.module;
  const auto isIn = [&](const Eigen::Vector2d& p) {
    const int turns = std::max(8, static_cast<int>(std::ceil(2 * std::numbers::pi * std::abs(p.x()) / pace)));
    for (int i = 0; i < turns; ++i) {
      const double angle = 2 * std::numbers::pi * i / turns;
      const Eigen::Vector3d at =
          frame * Eigen::Vector3d(p.x() * std::cos(angle), p.x() * std::sin(angle), p.y()) - other.origin;
      const double along = at.dot(other.axis);
      if (holdsDeep(its, {(at - along * other.axis).norm(), along}, kUnseen * other.spec.module)) return true;
    }
    return false;
  };
  return anyEdge(own, [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    const int pieces = std::max(1, static_cast<int>(std::ceil((b - a).norm() / pace)));
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
                       (apart - apart.dot(a.axis) * a.axis).norm() < 1e-9 * (1 + apart.norm());
  if (!oneLine) return false;
  const Outline first = outlineOf(a, a), second = outlineOf(b, a);
  return cross(first, second) || holds(first, within(second)) || holds(second, within(first));
}

}  // namespace geargraph
