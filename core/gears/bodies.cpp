#include "core/gears/bodies.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/base/contract.h"
#include "core/gears/sampling.h"

namespace geargraph {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using std::numbers::pi;

struct OutlineNode {
  Vector2d position;
  Vector2d normal;
};

/// Half of an arm: an eye with the part of the outline about it, up to the line where the halves meet.
class ArmHalf {
 public:
  ArmHalf(ShellBuilder& builder, const Eye& eye, double from, double to, double tolerance)
      : m_builder(builder), m_eye(eye), m_from(from), m_to(to), m_tolerance(tolerance) {}

  /// `outline` counter-clockwise about the eye, ascending in angle from the first.
  void add(const std::vector<OutlineNode>& outline) {
    const double start = angleOf(outline.front().position);
    const Loop top = face(outline, m_to, 1);
    const Loop bottom = face(outline, m_from, -1);
    m_builder.sew(top, eyeLoop(start, m_to, 1));
    m_builder.sew(eyeLoop(start, m_from, -1), bottom);
    if (m_eye.hole > 0) m_builder.sew(eyeLoop(start, m_to, 0), eyeLoop(start, m_from, 0));
  }

 private:
  [[nodiscard]] double angleOf(const Vector2d& p) const {
    return std::atan2(p.y() - m_eye.centre.y(), p.x() - m_eye.centre.x());
  }

  Loop face(const std::vector<OutlineNode>& outline, double z, double up) {
    Loop loop;
    for (const OutlineNode& node : outline) {
      double angle = angleOf(node.position);
      while (!loop.angles.empty() && angle < loop.angles.back()) angle += 2 * pi;
      loop.angles.push_back(angle);
      loop.vertices.push_back(m_builder.addVertex({node.position.x(), node.position.y(), z}, {0, 0, up}));
    }
    return loop;
  }

  /// The hole's rim, or the eye's centre where there is none. `up` 0: for the wall of the hole.
  Loop eyeLoop(double start, double z, double up) {
    const int count = m_eye.hole > 0 ? circleCount(m_eye.hole, m_tolerance) : 1;
    Loop loop;
    for (int i = 0; i < count; ++i) {
      const double angle = start + 2 * pi * i / count;
      const Vector2d out(std::cos(angle), std::sin(angle));
      const Vector2d p = m_eye.centre + m_eye.hole * out;
      const Vector3d normal = up == 0 ? Vector3d(-out.x(), -out.y(), 0) : Vector3d(0, 0, up);
      loop.vertices.push_back(m_builder.addVertex({p.x(), p.y(), z}, normal));
      loop.angles.push_back(angle);
    }
    return loop;
  }

  ShellBuilder& m_builder;
  const Eye& m_eye;
  double m_from, m_to, m_tolerance;
};

void addArc(std::vector<OutlineNode>& outline, const Eye& eye, double base, double from, double to,
            double tolerance) {
  const int n = chordsOfArc(to - from, eye.radius, tolerance);
  for (int i = 0; i <= n; ++i) {
    const double angle = base + from + (to - from) * i / n;
    const Vector2d out(std::cos(angle), std::sin(angle));
    outline.push_back({eye.centre + eye.radius * out, out});
  }
}

/// The outline's wall, from the nodes in order and back to the first. Normals are smooth: the hull has no
/// corner.
void addOuterWall(ShellBuilder& builder, const std::vector<OutlineNode>& outline, double from, double to) {
  std::vector<std::uint32_t> low;
  std::vector<std::uint32_t> high;
  for (const OutlineNode& node : outline) {
    const Vector3d normal(node.normal.x(), node.normal.y(), 0);
    low.push_back(builder.addVertex({node.position.x(), node.position.y(), from}, normal));
    high.push_back(builder.addVertex({node.position.x(), node.position.y(), to}, normal));
  }
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const std::size_t next = (i + 1) % outline.size();
    builder.addTriangle(low[i], low[next], high[next]);
    builder.addTriangle(low[i], high[next], high[i]);
  }
}

}  // namespace

Eigen::Isometry3d frameAlong(const Vector3d& origin, const Vector3d& axis, const Vector3d& towards) {
  Vector3d x = towards - towards.dot(axis) * axis;
  if (x.norm() < 1e-6 * towards.norm()) {
    const Vector3d other = std::abs(axis.z()) < 0.9 ? Vector3d::UnitZ() : Vector3d::UnitX();
    x = other - other.dot(axis) * axis;
  }
  x.normalize();
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
  frame.linear().col(0) = x;
  frame.linear().col(1) = axis.cross(x);
  frame.linear().col(2) = axis;
  frame.translation() = origin;
  return frame;
}

Solid lathed(std::span<const Circle> meridian, double tolerance) {
  GEARGRAPH_REQUIRE(meridian.size() >= 2);
  Solid solid;
  ShellBuilder builder(solid);
  double largest = 0;
  for (const Circle& c : meridian) largest = std::max(largest, c.radius);
  std::vector<Circle> closed(meridian.begin(), meridian.end());
  if (!(closed.front().radius == 0 && closed.back().radius == 0)) closed.push_back(closed.front());
  builder.addLathe(closed, circleCount(largest, tolerance), 0);
  return solid;
}

Solid tube(double outer, double inner, double from, double to, double tolerance) {
  const double chamfer = std::min({0.12 * (outer - inner), 0.25 * (to - from)});
  std::vector<Circle> meridian;
  if (inner > 0) {
    meridian = {{outer - chamfer, to}, {inner, to}, {inner, from}, {outer - chamfer, from}};
  } else {
    meridian = {{outer - chamfer, to}, {0, to}, {0, from}, {outer - chamfer, from}};
  }
  meridian.push_back({outer, from + chamfer});
  meridian.push_back({outer, to - chamfer});
  return lathed(meridian, tolerance);
}

Solid arm(const Eye& a, const Eye& b, double from, double to, double tolerance) {
  const Vector2d line = b.centre - a.centre;
  const double distance = line.norm();
  GEARGRAPH_REQUIRE(distance > std::abs(a.radius - b.radius));
  const double base = std::atan2(line.y(), line.x());
  const double tangent =
      std::acos((a.radius - b.radius) / distance);  // of both straight sides, from the line
  std::vector<OutlineNode> aroundA;
  addArc(aroundA, a, base, tangent, 2 * pi - tangent, tolerance);
  std::vector<OutlineNode> aroundB;
  addArc(aroundB, b, base, -tangent, tangent, tolerance);
  const auto middle = [](const OutlineNode& p, const OutlineNode& q) {
    return OutlineNode{0.5 * (p.position + q.position), p.normal};
  };
  const OutlineNode lower = middle(aroundA.back(), aroundB.front());
  const OutlineNode upper = middle(aroundB.back(), aroundA.front());

  std::vector<OutlineNode> wall = aroundA;
  wall.push_back(lower);
  wall.insert(wall.end(), aroundB.begin(), aroundB.end());
  wall.push_back(upper);
  aroundA.push_back(lower);
  aroundA.push_back(upper);
  aroundB.push_back(upper);
  aroundB.push_back(lower);

  Solid solid;
  ShellBuilder builder(solid);
  ArmHalf(builder, a, from, to, tolerance).add(aroundA);
  ArmHalf(builder, b, from, to, tolerance).add(aroundB);
  addOuterWall(builder, wall, from, to);
  return solid;
}

}  // namespace geargraph
