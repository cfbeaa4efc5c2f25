#include "core/gears/shell_builder.h"

#include <cmath>
#include <numbers>

#include "core/base/contract.h"
#include "core/gears/sampling.h"

namespace geargraph {
namespace {

using std::numbers::pi;

Float3 narrow(const Eigen::Vector3d& p) {
  return {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())};
}

}  // namespace

std::uint32_t ShellBuilder::addVertex(const Eigen::Vector3d& position, const Eigen::Vector3d& normal) {
  m_solid.positions.push_back(narrow(position));
  m_solid.normals.push_back(narrow(normal));
  return static_cast<std::uint32_t>(m_solid.positions.size() - 1);
}

Loop ShellBuilder::addCircle(const Circle& circle, int count, double start, const Eigen::Vector2d& normal) {
  Loop loop;
  if (circle.radius == 0) {
    loop.vertices.push_back(addVertex({0, 0, circle.height}, {0, 0, normal.y() < 0 ? -1.0 : 1.0}));
    loop.angles.push_back(start);
    return loop;
  }
  loop.vertices.reserve(static_cast<std::size_t>(count));
  loop.angles.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    const double angle = start + 2 * pi * i / count;
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    loop.vertices.push_back(addVertex({circle.radius * c, circle.radius * s, circle.height},
                                      {normal.x() * c, normal.x() * s, normal.y()}));
    loop.angles.push_back(angle);
  }
  return loop;
}

void ShellBuilder::sew(const Loop& a, const Loop& b) {
  const std::size_t na = a.vertices.size();
  const std::size_t nb = b.vertices.size();
  GEARGRAPH_REQUIRE(na >= 1 && nb >= 1);
  const auto angle = [](const Loop& loop, std::size_t i) {
    const std::size_t n = loop.angles.size();
    return i < n ? loop.angles[i] : loop.angles[i - n] + 2 * pi;
  };
  std::size_t i = 0;
  std::size_t j = 0;
  while (true) {
    const bool doneA = na == 1 || i == na;
    const bool doneB = nb == 1 || j == nb;
    if (doneA && doneB) break;
    const std::uint32_t va = a.vertices[i % na];
    const std::uint32_t vb = b.vertices[j % nb];
    // The shorter of the two diagonals, so that a long edge faces the middle of what lies across.
    if (doneB || (!doneA && angle(a, i + 1) - angle(b, j) <= angle(b, j + 1) - angle(a, i))) {
      addTriangle(va, a.vertices[(i + 1) % na], vb);
      ++i;
    } else {
      addTriangle(va, b.vertices[(j + 1) % nb], vb);
      ++j;
    }
  }
}

Eigen::Vector2d ShellBuilder::normalOf(const Circle& a, const Circle& b) const {
  const Eigen::Vector2d normal = Eigen::Vector2d(b.height - a.height, a.radius - b.radius).normalized();
  return m_inward ? -normal : normal;
}

void ShellBuilder::addLathe(std::span<const Circle> circles, int count, double start) {
  for (std::size_t i = 0; i + 1 < circles.size(); ++i) {
    const Circle& a = circles[i];
    const Circle& b = circles[i + 1];
    if (a == b || (a.radius == 0 && b.radius == 0)) continue;
    const Eigen::Vector2d normal = normalOf(a, b);
    const Loop from = addCircle(a, count, start, normal);
    sew(from, addCircle(b, count, start, normal));
  }
}

int circleCount(double radius, double tolerance) {
  return std::max(12, chordsOfArc(2 * pi, radius, tolerance));
}

}  // namespace geargraph
