#pragma once

#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

#include "core/machine/solids/solid.h"

namespace geargraph::test {

/// What an exact weld of a mesh turns out to be.
struct Topology {
  bool closed = true;    ///< every edge has exactly two triangles, in opposite directions
  bool balanced = true;  ///< every edge is met as often one way as the other: shells that touch weld to this
  bool manifold = true;  ///< the triangles round every vertex make one fan
  int pieces = 0;
  int genus = 0;  ///< of all pieces together
  int degenerate = 0;
  double worstNormal = 0;  ///< largest angle in degrees between a corner's normal and its facet
};

class Weld {
 public:
  explicit Weld(const Solid& solid) {
    std::map<Float3, int> ids;
    std::vector<int> weld;
    for (const Float3& p : solid.positions)
      weld.push_back(ids.emplace(p, static_cast<int>(ids.size())).first->second);
    m_vertices = static_cast<int>(ids.size());
    for (const Triangle& t : solid.triangles) m_faces.push_back({weld[t[0]], weld[t[1]], weld[t[2]]});
  }

  [[nodiscard]] Topology examine() const {
    Topology result;
    std::map<std::pair<int, int>, int> edges;
    std::vector<int> parent(static_cast<std::size_t>(m_vertices));
    std::iota(parent.begin(), parent.end(), 0);
    const auto root = [&](int v) {
      while (parent[v] != v) v = parent[v] = parent[parent[v]];
      return v;
    };
    std::vector<std::map<int, int>> fans(static_cast<std::size_t>(m_vertices));
    for (const auto& f : m_faces) {
      if (f[0] == f[1] || f[1] == f[2] || f[0] == f[2]) ++result.degenerate;
      for (int k = 0; k < 3; ++k) {
        ++edges[{f[k], f[(k + 1) % 3]}];
        parent[root(f[k])] = root(f[(k + 1) % 3]);
        if (!fans[f[k]].emplace(f[(k + 1) % 3], f[(k + 2) % 3]).second) result.manifold = false;
      }
    }
    for (const auto& [edge, count] : edges) {
      const auto back = edges.find({edge.second, edge.first});
      if (back == edges.end() || back->second != count) result.balanced = false;
      if (count != 1) result.closed = false;
    }
    result.closed = result.closed && result.balanced;
    for (const auto& fan : fans) result.manifold = result.manifold && oneCycle(fan);
    for (int v = 0; v < m_vertices; ++v) result.pieces += root(v) == v ? 1 : 0;
    const int euler = m_vertices - static_cast<int>(edges.size() / 2) + static_cast<int>(m_faces.size());
    result.genus = result.pieces - euler / 2;
    return result;
  }

 private:
  static bool oneCycle(const std::map<int, int>& next) {
    if (next.empty()) return false;
    int at = next.begin()->first;
    for (std::size_t i = 0; i < next.size(); ++i) {
      const auto found = next.find(at);
      if (found == next.end()) return false;
      at = found->second;
      if (at == next.begin()->first) return i + 1 == next.size();
    }
    return false;
  }

  int m_vertices = 0;
  std::vector<std::array<int, 3>> m_faces;
};

/// Largest angle between a vertex normal and the facets that use it, over facets with an area above `least`.
inline double worstNormalDegrees(const Solid& solid, double least) {
  double worst = 1;
  for (const Triangle& t : solid.triangles) {
    Eigen::Vector3d p[3];
    for (int k = 0; k < 3; ++k)
      p[k] = Eigen::Map<const Eigen::Vector3f>(solid.positions[t[k]].data()).cast<double>();
    const Eigen::Vector3d facet = (p[1] - p[0]).cross(p[2] - p[0]);
    if (facet.norm() / 2 < least) continue;
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d n = Eigen::Map<const Eigen::Vector3f>(solid.normals[t[k]].data()).cast<double>();
      worst = std::min(worst, facet.normalized().dot(n));
    }
  }
  return std::acos(worst) * 180 / M_PI;
}

inline Topology topologyOf(const Solid& solid) {
  return Weld(solid).examine();
}

}  // namespace geargraph::test
