#include "core/presentation/gl_renderer/primitives.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/foundations/base/contract.h"

namespace geargraph {
namespace {

Float3 narrowed(const Eigen::Vector3d& value) {
  return {static_cast<float>(value.x()), static_cast<float>(value.y()), static_cast<float>(value.z())};
}

/// A vertex with its normal. Zeros lose their signs, so that equal positions are equal bit by bit.
void addVertex(Solid& mesh, const Eigen::Vector3d& position, const Eigen::Vector3d& normal) {
  mesh.positions.push_back(narrowed(position.array() + 0.0));
  mesh.normals.push_back(narrowed(normal));
}

/// One band of a surface of revolution: two rings of vertices with the band's own normals.
void addBand(Solid& mesh, const Eigen::Vector2d& a, const Eigen::Vector2d& b, int sides) {
  const Eigen::Vector2d along = (b - a).normalized();
  const Eigen::Vector2d outward(along.y(), -along.x());
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (int k = 0; k < sides; ++k) {
    const double angle = 2 * std::numbers::pi * k / sides;
    const double cosine = std::cos(angle), sine = std::sin(angle);
    for (const Eigen::Vector2d& point : {a, b}) {
      addVertex(mesh, {point.x() * cosine, point.x() * sine, point.y()},
                {outward.x() * cosine, outward.x() * sine, outward.y()});
    }
  }
  for (int k = 0; k < sides; ++k) {
    const std::uint32_t here = first + 2 * static_cast<std::uint32_t>(k);
    const std::uint32_t next = first + 2 * static_cast<std::uint32_t>((k + 1) % sides);
    if (a.x() > 0) mesh.triangles.push_back({here, next, next + 1});
    if (b.x() > 0) mesh.triangles.push_back({here, next + 1, here + 1});
  }
}

}  // namespace

Solid revolvedSolid(const std::vector<Eigen::Vector2d>& outline, int sides) {
  GEARGRAPH_REQUIRE(sides >= 3 && outline.size() >= 2);
  Solid mesh;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Eigen::Vector2d& a = outline[i];
    const Eigen::Vector2d& b = outline[(i + 1) % outline.size()];
    if (a.x() > 0 || b.x() > 0) addBand(mesh, a, b, sides);
  }
  return mesh;
}

Solid cylinderSolid(double radius, double from, double to, int sides) {
  GEARGRAPH_REQUIRE(radius > 0 && from < to);
  const double chamfer = std::min(0.2 * radius, 0.25 * (to - from));
  return revolvedSolid({{0, from},
                        {radius - chamfer, from},
                        {radius, from + chamfer},
                        {radius, to - chamfer},
                        {radius - chamfer, to},
                        {0, to}},
                       sides);
}

Solid boxSolid(const Eigen::Vector3d& low, const Eigen::Vector3d& high) {
  GEARGRAPH_REQUIRE((low.array() < high.array()).all());
  Solid mesh;
  for (int axis = 0; axis < 3; ++axis) {
    for (const int side : {-1, 1}) {
      const int u = (axis + 1) % 3, v = (axis + 2) % 3;
      const auto first = static_cast<std::uint32_t>(mesh.positions.size());
      for (const auto& [alongU, alongV] : {std::array{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
        Eigen::Vector3d corner, normal = Eigen::Vector3d::Zero();
        corner[axis] = side > 0 ? high[axis] : low[axis];
        corner[u] = alongU ? high[u] : low[u];
        corner[v] = alongV ? high[v] : low[v];
        normal[axis] = side;
        addVertex(mesh, corner, normal);
      }
      if (side > 0) {
        mesh.triangles.insert(mesh.triangles.end(),
                              {{first, first + 1, first + 2}, {first, first + 2, first + 3}});
      } else {
        mesh.triangles.insert(mesh.triangles.end(),
                              {{first, first + 2, first + 1}, {first, first + 3, first + 2}});
      }
    }
  }
  return mesh;
}

}  // namespace geargraph
