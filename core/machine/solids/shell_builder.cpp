#include "core/machine/solids/shell_builder.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "core/foundations/base/contract.h"
#include "core/machine/teeth/sampling.h"

namespace geargraph {
namespace {

using std::numbers::pi;

Float3 narrow(const Eigen::Vector3d& p) {
  return {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())};
}

}  // namespace

void beginLoopAt(Loop& loop, double start) {
  for (double& angle : loop.angles) angle -= 2 * pi * std::floor((angle - start) / (2 * pi));
  const auto first = std::min_element(loop.angles.begin(), loop.angles.end()) - loop.angles.begin();
  std::rotate(loop.angles.begin(), loop.angles.begin() + first, loop.angles.end());
  std::rotate(loop.vertices.begin(), loop.vertices.begin() + first, loop.vertices.end());
}

std::uint32_t ShellBuilder::addVertex(const Eigen::Vector3d& position, const Eigen::Vector3d& normal) {
  m_solid.positions.push_back(narrow(position));
  m_solid.normals.push_back(narrow(normal));
  return static_cast<std::uint32_t>(m_solid.positions.size() - 1);
}

const std::vector<ShellBuilder::Turn>& ShellBuilder::turnsOf(int count, double start) {
  if (static_cast<std::size_t>(count) == m_turns.size() && start == m_start) return m_turns;
  m_turns.resize(static_cast<std::size_t>(count));
  m_start = start;
  for (int i = 0; i < count; ++i) {
    const double angle = start + 2 * pi * i / count;
    m_turns[static_cast<std::size_t>(i)] = {angle, std::cos(angle), std::sin(angle)};
  }
  return m_turns;
}

std::uint32_t ShellBuilder::write(const ProfileVertex& circle, const std::vector<Turn>& turns,
                                  const Eigen::Vector2d& normal) {
  const std::size_t first = m_solid.positions.size();
  if (circle.radius == 0) {
    return addVertex({0, 0, circle.height}, {0, 0, normal.y() < 0 ? -1.0 : 1.0});
  }
  m_solid.positions.resize(first + turns.size());
  m_solid.normals.resize(first + turns.size());
  Float3* position = m_solid.positions.data() + first;
  Float3* direction = m_solid.normals.data() + first;
  for (const Turn& t : turns) {
    *position++ = narrow({circle.radius * t.c, circle.radius * t.s, circle.height});
    *direction++ = narrow({normal.x() * t.c, normal.x() * t.s, normal.y()});
  }
  return static_cast<std::uint32_t>(first);
}

Loop ShellBuilder::addCircle(const ProfileVertex& circle, int count, double start,
                             const Eigen::Vector2d& normal) {
  const std::vector<Turn>& turns = turnsOf(count, start);
  const std::uint32_t first = write(circle, turns, normal);
  Loop loop;
  if (circle.radius == 0) return {{first}, {start}};
  loop.vertices.resize(turns.size());
  loop.angles.reserve(turns.size());
  std::iota(loop.vertices.begin(), loop.vertices.end(), first);
  for (const Turn& t : turns) loop.angles.push_back(t.angle);
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

void ShellBuilder::sewAlike(std::uint32_t a, bool poleA, std::uint32_t b, bool poleB, std::uint32_t count) {
  std::vector<Triangle>& triangles = m_solid.triangles;
  const std::size_t first = triangles.size();
  triangles.resize(first + count * (poleA || poleB ? 1U : 2U));
  Triangle* out = triangles.data() + first;
  const std::size_t second = m_inward ? 2 : 1, third = 3 - second;
  const auto put = [&](std::uint32_t x, std::uint32_t y, std::uint32_t z) {
    (*out)[0] = x;
    (*out)[second] = y;
    (*out)[third] = z;
    ++out;
  };
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t next = i + 1 == count ? 0 : i + 1;
    if (!poleA) put(a + i, a + next, poleB ? b : b + i);
    if (!poleB) put(poleA ? a : a + next, b + next, b + i);
  }
}

Eigen::Vector2d ShellBuilder::normalOf(const ProfileVertex& a, const ProfileVertex& b) const {
  const Eigen::Vector2d normal = Eigen::Vector2d(b.height - a.height, a.radius - b.radius).normalized();
  return m_inward ? -normal : normal;
}

void ShellBuilder::addRevolved(std::span<const ProfileVertex> circles, int count, double start) {
  const std::vector<Turn>& turns = turnsOf(count, start);
  for (std::size_t i = 0; i + 1 < circles.size(); ++i) {
    const ProfileVertex& a = circles[i];
    const ProfileVertex& b = circles[i + 1];
    if (a == b || (a.radius == 0 && b.radius == 0)) continue;
    const Eigen::Vector2d normal = normalOf(a, b);
    const std::uint32_t from = write(a, turns, normal);
    const std::uint32_t to = write(b, turns, normal);
    sewAlike(from, a.radius == 0, to, b.radius == 0, static_cast<std::uint32_t>(count));
  }
}

int circleCount(double radius, double tolerance) {
  return std::max(12, chordsOfArc(2 * pi, radius, tolerance));
}

}  // namespace geargraph
