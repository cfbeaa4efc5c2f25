#pragma once

#include <algorithm>
#include <map>
#include <utility>

#include "core/presentation/meshfile/mesh_scene.h"
#include "core/presentation/meshfile/weld.h"

namespace geargraph::test {

/// A wheel with `teeth` blunt teeth between the radii 0.8 r and r, `width` wide, about +z: closed, with a
/// normal of its own for each face at every edge, as the gears have. Made here, so that files are tested
/// without the generator of gears.
[[nodiscard]] Solid cog(int teeth, double radius, double width);

/// Two links of a train: a carrier that makes one turn and a planet on it that makes three the other way, in
/// 4 s, about axes that do not pass through the origin; a ground with the same cog twice.
[[nodiscard]] MeshScene movingScene();

/// Every edge belongs to exactly two triangles, which run along it in opposite directions.
[[nodiscard]] inline bool isClosed(const WeldedMesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) ++edges[{t[k], t[(k + 1) % 3]}];
  }
  for (const auto& [edge, count] : edges) {
    const auto opposite = edges.find({edge.second, edge.first});
    if (count != 1 || opposite == edges.end()) return false;
  }
  return !edges.empty();
}

/// As isClosed(), but bodies of several shells may touch along an edge.
[[nodiscard]] inline bool isBalanced(const WeldedMesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k];
      const std::uint32_t b = t[(k + 1) % 3];
      edges[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
    }
  }
  return std::all_of(edges.begin(), edges.end(), [](const auto& edge) { return edge.second == 0; });
}

}  // namespace geargraph::test
