#include "core/machine/train/bevel_collision.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/machine/solids/gear_body.h"
#include "core/machine/solids/part_solids.h"
#include "core/mechanism/placement/tolerance.h"

namespace geargraph {
namespace {

/// (radius, coordinate along the first wheel's axis), a closed polygon.
using PlaneOutline = std::vector<Eigen::Vector2d>;

PlaneOutline outlineOf(const TrainWheel& wheel, const TrainWheel& along) {
  const double origin = (wheel.origin - along.origin).dot(along.axis);
  const double sense = wheel.axis.dot(along.axis);
  PlaneOutline outline;
  for (const ProfileVertex& c : wheelOutline(wheel.spec))
    outline.emplace_back(c.radius, origin + sense * c.height);
  return outline;
}

double side(const Eigen::Vector2d& from, const Eigen::Vector2d& to, const Eigen::Vector2d& p) {
  const Eigen::Vector2d way = to - from, out = p - from;
  return way.x() * out.y() - way.y() * out.x();
}

template <class Visit>
bool anyEdge(const PlaneOutline& outline, Visit visit) {
  for (std::size_t i = 0; i < outline.size(); ++i) {
    if (visit(outline[i], outline[(i + 1) % outline.size()])) return true;
  }
  return false;
}

bool cross(const PlaneOutline& a, const PlaneOutline& b) {
  return anyEdge(a, [&](const Eigen::Vector2d& p, const Eigen::Vector2d& q) {
    return anyEdge(b, [&](const Eigen::Vector2d& r, const Eigen::Vector2d& s) {
      return side(p, q, r) * side(p, q, s) < 0 && side(r, s, p) * side(r, s, q) < 0;
    });
  });
}

bool holds(const PlaneOutline& outline, const Eigen::Vector2d& p) {
  bool inside = false;
  anyEdge(outline, [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    const bool between = (a.y() > p.y()) != (b.y() > p.y());
    if (between && p.x() < a.x() + (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y())) inside = !inside;
    return false;
  });
  return inside;
}

/// A point of its own: the middle of the outline's teeth.
Eigen::Vector2d within(const PlaneOutline& outline) {
  return (outline.front() + outline.back() + outline[outline.size() - 2]) / 3;
}

constexpr double kPace = 0.7;       // modules between the points that are looked at
constexpr double kUnseen = 0.15;    // modules by which wheels may lie in each other
constexpr double kMaxTurns = 1500;  // points of a circle; a wheel of 330 teeth has as many at that pace

/// How deep a point lies within the outline: its distance from the nearest edge, below 0 outside. It changes
/// by no more than the way between two points of space.
double depthIn(const PlaneOutline& outline, const Eigen::Vector2d& p) {
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

/// The radius of the bounding sphere of the wheel of an outline.
double sizeOf(const PlaneOutline& outline) {
  double radius = 0, low = 1e300, high = -1e300;
  for (const Eigen::Vector2d& c : outline) {
    radius = std::max(radius, std::abs(c.x()));
    low = std::min(low, c.y());
    high = std::max(high, c.y());
  }
  return std::hypot(radius, (high - low) / 2);
}

/// A frame on the wheel whose x points to the other one, so that the same points are looked at wherever both
/// are turned to. Of coaxial wheels any x will do.
Eigen::Isometry3d frameTowards(const TrainWheel& wheel, const TrainWheel& other) {
  const Eigen::Vector3d apart = other.origin - wheel.origin;
  const Eigen::Vector3d across = apart - apart.dot(wheel.axis) * wheel.axis;
  const double size = wheel.workingRadius + other.workingRadius;
  return frameAlong(wheel.origin, wheel.axis, across.norm() > kSameLine * size ? across : other.axis);
}

/// Does a point of one wheel's surface lie in the other? A point outside of it tells how far the next ones
/// are outside, too: of a large wheel only few points are looked at but where a small one is near.
class SurfaceSearch {
 public:
  SurfaceSearch(const TrainWheel& wheel, const TrainWheel& other)
      : m_own(outlineOf(wheel, wheel)),
        m_its(outlineOf(other, other)),
        m_other(other),
        m_frame(frameTowards(wheel, other)) {
    const double module = std::min(wheel.spec.module, other.spec.module);
    const double size = std::min(sizeOf(m_own), sizeOf(m_its));
    m_pace = std::max(kPace * module, 2 * std::numbers::pi * size / kMaxTurns);
    m_deep = kUnseen * module;
  }

  [[nodiscard]] bool reachesInto() const {
    return anyEdge(m_own, [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
      const double edge = (b - a).norm();
      for (double at = 0; at < edge || at == 0;) {
        const double missing = ofCircle(a + (b - a) * (edge > 0 ? at / edge : 0));
        if (missing < 0) return true;
        at += std::max(m_pace, missing);
      }
      return false;
    });
  }

 private:
  /// What every point of the circle misses at least to lie deep enough in the other wheel; below 0 where one
  /// does. Each point is passed by what the one before misses, so those between miss half of that.
  [[nodiscard]] double ofCircle(const Eigen::Vector2d& p) const {
    const double radius = std::abs(p.x());
    double least = 1e300;
    for (double angle = 0; angle < 2 * std::numbers::pi;) {
      const double missing = ofPoint(p, angle);
      least = std::min(least, missing);
      if (missing < 0) break;
      const double way = std::max(m_pace, missing);
      if (way >= 2 * std::numbers::pi * radius) break;
      angle += way / radius;
    }
    return least < 0 ? least : least / 2;
  }

  [[nodiscard]] double ofPoint(const Eigen::Vector2d& p, double angle) const {
    const Eigen::Vector3d at =
        m_frame * Eigen::Vector3d(p.x() * std::cos(angle), p.x() * std::sin(angle), p.y()) - m_other.origin;
    const double along = at.dot(m_other.axis);
    return m_deep - depthIn(m_its, {(at - along * m_other.axis).norm(), along});
  }

  PlaneOutline m_own, m_its;
  const TrainWheel& m_other;
  Eigen::Isometry3d m_frame;
  double m_pace = 0;  ///< between points
  double m_deep = 0;
};

}  // namespace

bool bevelsCross(const TrainWheel& a, const TrainWheel& b) {
  return SurfaceSearch(a, b).reachesInto() || SurfaceSearch(b, a).reachesInto();
}

bool bevelsCollide(const TrainWheel& a, const TrainWheel& b) {
  const Eigen::Vector3d apart = b.origin - a.origin;
  const bool oneLine = std::abs(std::abs(a.axis.dot(b.axis)) - 1) < 1e-12 &&
                       (apart - apart.dot(a.axis) * a.axis).norm() <= kSameLine * a.workingRadius;
  if (!oneLine) return false;
  const PlaneOutline first = outlineOf(a, a), second = outlineOf(b, a);
  return cross(first, second) || holds(first, within(second)) || holds(second, within(first));
}

}  // namespace geargraph
