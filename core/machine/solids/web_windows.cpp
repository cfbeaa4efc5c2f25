#include "core/machine/solids/web_windows.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/foundations/base/contract.h"
#include "core/machine/teeth/sampling.h"

namespace geargraph {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using std::numbers::pi;

struct Node {
  Vector2d position;
  Vector2d outward;  ///< from the window's middle
};

/// Half angle of the window's corner centres at a radius: beside the spoke by half its width and the corner.
double cornerAngle(const WebWindows& w, double radius) {
  return pi / w.count - std::asin((w.spoke / 2 + w.corner) / radius);
}

/// The outline of the window at angle 0 in points: corners with both ends, circles without.
std::vector<Node> outlineOf(const WebWindows& w, double tolerance) {
  std::vector<Node> nodes;
  const std::vector<PlanarArc> arcs = windowOutline(w, 0);
  for (std::size_t arc = 0; arc < arcs.size(); ++arc) {
    const auto& [centre, radius, from, to] = arcs[arc];
    const bool isCorner = arc % 3 != 1;
    const double sense = to > from ? 1 : -1;
    int n = chordsOfArc(to - from, radius, tolerance);
    if (isCorner) n = std::max(n, static_cast<int>((to - from) / 0.4) + 1);
    for (int i = isCorner ? 0 : 1; i < (isCorner ? n + 1 : n); ++i) {
      const double direction = from + (to - from) * i / n;
      const Vector2d out(std::cos(direction), std::sin(direction));
      nodes.push_back({centre + radius * out, sense * out});
    }
  }
  return nodes;
}

/// A loop about a middle off the axis: angles about it, ascending from the smallest.
Loop loopAbout(const Solid& solid, std::vector<std::uint32_t> vertices, const Vector2d& middle) {
  std::vector<double> angles;
  for (const std::uint32_t v : vertices) {
    const Float3& p = solid.positions[v];
    angles.push_back(std::atan2(p[1] - middle.y(), p[0] - middle.x()));
  }
  const auto first = std::min_element(angles.begin(), angles.end()) - angles.begin();
  std::rotate(vertices.begin(), vertices.begin() + first, vertices.end());
  std::rotate(angles.begin(), angles.begin() + first, angles.end());
  return {std::move(vertices), std::move(angles)};
}

class WebBuilder {
 public:
  WebBuilder(ShellBuilder& builder, const WebWindows& windows, int count, double start, double tolerance)
      : m_builder(builder),
        m_windows(windows),
        m_count(count),
        m_start(start),
        m_outline(outlineOf(windows, tolerance)) {}

  void addFace(double up) {
    const double z = up * m_windows.half;
    const Loop rim = m_builder.addCircle({m_windows.rim, z}, m_count, m_start, {0, up});
    const Loop hub = m_builder.addCircle({m_windows.hub, z}, m_count, m_start, {0, up});
    const int step = m_count / m_windows.count;
    std::vector<std::vector<std::uint32_t>> borders;  // between the sectors, along the spokes' middles
    for (int k = 0; k < m_windows.count; ++k) borders.push_back(addBorder(k, z, up));
    for (int k = 0; k < m_windows.count; ++k) {
      std::vector<std::uint32_t> sector;
      const auto& right = borders[static_cast<std::size_t>(k)];
      const auto& left = borders[static_cast<std::size_t>((k + 1) % m_windows.count)];
      for (int i = 0; i <= step; ++i) sector.push_back(at(rim, k * step + i));
      sector.insert(sector.end(), left.begin(), left.end());
      for (int i = step; i >= 0; --i) sector.push_back(at(hub, k * step + i));
      sector.insert(sector.end(), right.rbegin(), right.rend());
      const double angle = angleOf(k);
      const double radius = 0.5 * (m_windows.inner + m_windows.outer);
      const Vector2d middle(radius * std::cos(angle), radius * std::sin(angle));
      const Loop outside = loopAbout(m_builder.solid(), std::move(sector), middle);
      const Loop inside = loopAbout(m_builder.solid(), addOutline(k, z, up), middle);
      if (up > 0) {
        m_builder.sew(outside, inside);
      } else {
        m_builder.sew(inside, outside);
      }
    }
  }

  void addWalls() {
    for (int k = 0; k < m_windows.count; ++k) {
      const auto high = addOutline(k, m_windows.half, 0);
      const auto low = addOutline(k, -m_windows.half, 0);
      for (std::size_t i = 0; i < high.size(); ++i) {
        const std::size_t next = (i + 1) % high.size();
        m_builder.addTriangle(high[i], high[next], low[next]);
        m_builder.addTriangle(high[i], low[next], low[i]);
      }
    }
  }

 private:
  [[nodiscard]] double angleOf(int k) const { return m_start + (2 * k + 1) * pi / m_windows.count; }
  /// Points between rim and hub on the border before sector k, so that no edge there is long.
  std::vector<std::uint32_t> addBorder(int k, double z, double up) {
    constexpr int kParts = 12;
    const double angle = m_start + 2 * pi * k / m_windows.count;
    std::vector<std::uint32_t> vertices;
    for (int i = 1; i < kParts; ++i) {
      const double radius = m_windows.rim + (m_windows.hub - m_windows.rim) * i / kParts;
      vertices.push_back(
          m_builder.addVertex({radius * std::cos(angle), radius * std::sin(angle), z}, {0, 0, up}));
    }
    return vertices;
  }

  [[nodiscard]] std::uint32_t at(const Loop& loop, int i) const {
    return loop.vertices[static_cast<std::size_t>(i % m_count)];
  }

  /// The outline of window k at a height; `up` 0: with the normals of the wall, which point into the window.
  std::vector<std::uint32_t> addOutline(int k, double z, double up) {
    const Eigen::Rotation2Dd turn(angleOf(k));
    std::vector<std::uint32_t> vertices;
    for (const Node& node : m_outline) {
      const Vector2d p = turn * node.position;
      const Vector2d n = turn * node.outward;
      const Vector3d normal = up == 0 ? Vector3d(-n.x(), -n.y(), 0) : Vector3d(0, 0, up);
      vertices.push_back(m_builder.addVertex({p.x(), p.y(), z}, normal));
    }
    return vertices;
  }

  ShellBuilder& m_builder;
  const WebWindows& m_windows;
  int m_count;
  double m_start;
  std::vector<Node> m_outline;
};

}  // namespace

std::optional<WebWindows> windowsFor(double hub, double rim, double half, double module) {
  WebWindows w;
  w.hub = hub;
  w.rim = rim;
  w.half = half;
  w.outer = rim - 0.8 * module;
  w.count = rim > 40 * module ? 6 : 5;
  w.spoke = std::clamp(0.16 * (w.outer - hub), 2.5 * module, 6 * module);
  // Spokes keep apart at the hub: windows begin where they leave each other a good third of the circle.
  w.inner = std::max(hub + 0.8 * module, 0.7 * w.spoke / std::sin(0.6 * pi / w.count));
  const double height = w.outer - w.inner;
  if (height < 4 * module) return std::nullopt;
  for (w.corner = std::min(0.25 * height, 5 * module); w.corner > 0.4 * module; w.corner *= 0.8) {
    const double reach = (w.spoke / 2 + w.corner) / (w.inner + w.corner);
    if (reach < std::sin(0.85 * pi / w.count)) return w;
  }
  return std::nullopt;
}

std::vector<PlanarArc> windowOutline(const WebWindows& w, double turn) {
  const double far = w.outer - w.corner;
  const double near = w.inner + w.corner;
  const double farAngle = cornerAngle(w, far);
  const double nearAngle = cornerAngle(w, near);
  const double side = pi / w.count + pi / 2;  // outward direction of the side at positive angles
  const auto corner = [&](double radius, double angle, double from, double to) {
    const Vector2d centre = radius * Vector2d(std::cos(turn + angle), std::sin(turn + angle));
    return PlanarArc{centre, w.corner, turn + from, turn + to};
  };
  const Vector2d middle = Vector2d::Zero();
  return {corner(far, -farAngle, -side, -farAngle),
          {middle, w.outer, turn - farAngle, turn + farAngle},
          corner(far, farAngle, farAngle, side),
          corner(near, nearAngle, side, nearAngle + pi),
          {middle, w.inner, turn + nearAngle, turn - nearAngle},
          corner(near, -nearAngle, pi - nearAngle, 2 * pi - side)};
}

void addWindowedWeb(ShellBuilder& builder, const WebWindows& windows, int count, double start,
                    double tolerance) {
  GEARGRAPH_REQUIRE(count % windows.count == 0);
  WebBuilder web(builder, windows, count, start, tolerance);
  web.addFace(1);
  web.addFace(-1);
  web.addWalls();
}

}  // namespace geargraph
