#include "core/mechanism/placement/disc_hull.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/foundations/base/contract.h"

namespace geargraph {
namespace {

constexpr int kMaxHullSteps = 60;
constexpr double kTouch = 1e-9;  // of both sizes: hulls that touch are near, however rounding has it

/// Across a disc's axis, relative to the direction: less is rounding, which must not choose a point of the
/// rim.
constexpr double kAcross = 1e-10;
/// A triangle or tetrahedron this flat, in parts of the product of its edges, holds no point that its edges
/// or faces do not come as near to; rounding decides whether it does.
constexpr double kFlatTriangle = 1e-14;
constexpr double kFlatTetrahedron = 1e-10;

/// The hull's point that lies farthest in a direction.
Vector3 farthest(const DiscHull& hull, const Vector3& direction) {
  Vector3 best{};
  double most = -1e300;
  const double least = kAcross * length(direction);
  for (const Disc& disc : hull) {
    const Vector3 across = direction - dot(direction, disc.axis) * disc.axis;
    const double width = length(across);
    const double reach = dot(disc.centre, direction) + disc.radius * width;
    if (reach <= most) continue;
    most = reach;
    best = width > least ? disc.centre + (disc.radius / width) * across : disc.centre;
  }
  return best;
}

/// The bounding sphere of a hull.
struct HullSphere {
  Vector3 centre{};
  double radius = 0;

  explicit HullSphere(const DiscHull& hull) {
    for (const Disc& disc : hull) centre = centre + (1.0 / static_cast<double>(hull.size())) * disc.centre;
    for (const Disc& disc : hull) radius = std::max(radius, length(disc.centre - centre) + disc.radius);
  }
};

/// Up to four points of the difference of two hulls, no more of them than their nearest point needs.
class Simplex {
 public:
  void add(const Vector3& p) { m_points[m_count++] = p; }

  /// The point of their hull that is nearest to the origin; keeps only the points it lies between. Nothing
  /// where the origin lies within four of them.
  std::optional<Vector3> nearest() {
    double best = 1e300;
    unsigned chosen = 1;
    Vector3 found{};
    for (unsigned subset = 1; subset < (1U << m_count); ++subset) {
      std::array<Vector3, 4> some{};
      std::size_t count = 0;
      for (std::size_t i = 0; i < m_count; ++i) {
        if ((subset >> i & 1U) != 0) some[count++] = m_points[i];
      }
      const auto p = between(some, count);
      if (!p) continue;
      const double square = dot(*p, *p);
      if (count == 4) return std::nullopt;
      if (square >= best) continue;
      best = square;
      chosen = subset;
      found = *p;
    }
    std::size_t kept = 0;
    for (std::size_t i = 0; i < m_count; ++i) {
      if ((chosen >> i & 1U) != 0) m_points[kept++] = m_points[i];
    }
    m_count = kept;
    return found;
  }

 private:
  /// The nearest point of the plane through `count` points, where it lies between all of them.
  static std::optional<Vector3> between(const std::array<Vector3, 4>& p, std::size_t count) {
    if (count == 1) return p[0];
    const Vector3 a = p[1] - p[0];
    if (count == 2) {
      const double share = -dot(p[0], a) / dot(a, a);
      if (!(share > 0 && share < 1)) return std::nullopt;
      return p[0] + share * a;
    }
    const Vector3 b = p[2] - p[0];
    if (count == 3) {
      const double aa = dot(a, a), ab = dot(a, b), bb = dot(b, b), pa = -dot(p[0], a), pb = -dot(p[0], b);
      const double whole = aa * bb - ab * ab;
      if (whole <= kFlatTriangle * aa * bb) return std::nullopt;
      const double s = (pa * bb - pb * ab) / whole, t = (pb * aa - pa * ab) / whole;
      if (!(s > 0 && t > 0 && s + t < 1)) return std::nullopt;
      return p[0] + s * a + t * b;
    }
    const Vector3 c = p[3] - p[0], origin = -1.0 * p[0];
    const double whole = dot(a, cross(b, c));
    const double edges = std::max(length(a), length(origin)) * length(b) * length(c);
    if (std::abs(whole) <= kFlatTetrahedron * edges) return std::nullopt;
    const double s = dot(origin, cross(b, c)) / whole, t = dot(origin, cross(c, a)) / whole,
                 u = dot(origin, cross(a, b)) / whole;
    if (!(s > 0 && t > 0 && u > 0 && s + t + u < 1)) return std::nullopt;
    return Vector3{};
  }

  std::array<Vector3, 4> m_points{};
  std::size_t m_count = 0;
};

}  // namespace

bool areNear(const DiscHull& a, const DiscHull& b, double margin) {
  GEARGRAPH_REQUIRE(!a.empty() && !b.empty());
  const HullSphere sphereA(a), sphereB(b);
  const double size = sphereA.radius + sphereB.radius;
  const double near = margin + kTouch * size;
  if (length(sphereA.centre - sphereB.centre) > size + near) return false;
  Simplex simplex;
  Vector3 nearest = sphereA.centre - sphereB.centre;  // no point of the difference, but a direction
  if (length(nearest) == 0) return true;
  simplex.add(farthest(a, -1.0 * nearest) - farthest(b, nearest));
  for (int i = 0; i < kMaxHullSteps; ++i) {
    const auto p = simplex.nearest();
    if (!p) return true;
    nearest = *p;
    const double distance = length(nearest);
    if (distance <= near) return true;
    const Vector3 next = farthest(a, -1.0 * nearest) - farthest(b, nearest);
    if (dot(nearest, next) > near * distance) return false;  // a plane keeps them apart
    if (distance * distance - dot(nearest, next) < kTouch * size * distance) return false;
    simplex.add(next);
  }
  return true;
}

DiscHull turned(const DiscHull& hull, const Vector3& point, const Vector3& direction, double angle) {
  const double cosine = std::cos(angle), sine = std::sin(angle);
  const auto turn = [&](const Vector3& v) {
    return cosine * v + sine * cross(direction, v) + ((1 - cosine) * dot(direction, v)) * direction;
  };
  DiscHull result;
  result.reserve(hull.size());
  for (const Disc& disc : hull)
    result.push_back({point + turn(disc.centre - point), turn(disc.axis), disc.radius});
  return result;
}

}  // namespace geargraph
