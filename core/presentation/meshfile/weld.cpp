#include "core/presentation/meshfile/weld.h"

#include <algorithm>
#include <bit>
#include <compare>
#include <cstdint>
#include <limits>
#include <unordered_map>

#include "core/foundations/base/disjoint_sets.h"

namespace geargraph {
namespace {

struct PositionHash {
  std::size_t operator()(const Float3& p) const {
    std::uint64_t hash = 0;
    for (const float coordinate : p) {
      hash = (hash ^ std::bit_cast<std::uint32_t>(coordinate)) * 0x9E3779B97F4A7C15ULL;
      hash ^= hash >> 29U;
    }
    return static_cast<std::size_t>(hash);
  }
};

/// One side of a triangle, as it lies on the edge between two vertices.
struct EdgeSide {
  std::uint32_t low = 0;
  std::uint32_t high = 0;
  bool isBackward = false;  ///< runs from high to low
  std::uint32_t side = 0;   ///< 3 * triangle + corner where it begins
  friend auto operator<=>(const EdgeSide&, const EdgeSide&) = default;
};

std::uint32_t nextSide(std::uint32_t side) {
  return side % 3 == 2 ? side - 2 : side + 1;
}

std::vector<EdgeSide> sortedSides(const WeldedMesh& mesh) {
  std::vector<EdgeSide> sides;
  sides.reserve(3 * mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t from = mesh.triangles[t][k];
      const std::uint32_t to = mesh.triangles[t][(k + 1) % 3];
      sides.push_back({std::min(from, to), std::max(from, to), from > to, 3 * t + k});
    }
  }
  std::sort(sides.begin(), sides.end());
  return sides;
}

}  // namespace

WeldedMesh welded(const Solid& solid) {
  WeldedMesh mesh;
  std::unordered_map<Float3, std::uint32_t, PositionHash> places;
  places.reserve(solid.positions.size());
  std::vector<std::uint32_t> place;
  place.reserve(solid.positions.size());
  for (const Float3& position : solid.positions) {
    const Float3 clean = withoutNegativeZeros(position);
    const auto [found, isNew] = places.try_emplace(clean, static_cast<std::uint32_t>(mesh.positions.size()));
    if (isNew) mesh.positions.push_back(clean);
    place.push_back(found->second);
  }
  mesh.triangles.reserve(solid.triangles.size());
  for (const Triangle& t : solid.triangles) {
    const Triangle joined{place[t[0]], place[t[1]], place[t[2]]};
    const bool collapsed = joined[0] == joined[1] || joined[1] == joined[2] || joined[2] == joined[0];
    if (!collapsed) mesh.triangles.push_back(joined);
  }
  return mesh;
}

WeldedMesh weldedToManifold(const Solid& solid) {
  const WeldedMesh mesh = welded(solid);
  const std::vector<EdgeSide> sides = sortedSides(mesh);
  DisjointSets corners(  // of triangles that are one vertex
      sides.size());
  for (std::size_t first = 0; first < sides.size();) {
    std::size_t backward = first;  // forward sides of the edge come first, both kinds in order of triangles
    const auto isSameEdge = [&](std::size_t i) {
      return i < sides.size() && sides[i].low == sides[first].low && sides[i].high == sides[first].high;
    };
    while (isSameEdge(backward) && !sides[backward].isBackward) ++backward;
    std::size_t end = backward;
    while (isSameEdge(end)) ++end;
    for (std::size_t i = first, j = backward; i < backward && j < end; ++i, ++j) {
      corners.join(sides[i].side, nextSide(sides[j].side));
      corners.join(nextSide(sides[i].side), sides[j].side);
    }
    first = end;
  }
  WeldedMesh parted;
  std::vector<std::uint32_t> vertexOf(sides.size(), std::numeric_limits<std::uint32_t>::max());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    Triangle& triangle = parted.triangles.emplace_back();
    for (std::uint32_t k = 0; k < 3; ++k) {
      std::uint32_t& vertex = vertexOf[corners.root(3 * t + k)];
      if (vertex == std::numeric_limits<std::uint32_t>::max()) {
        vertex = static_cast<std::uint32_t>(parted.positions.size());
        parted.positions.push_back(mesh.positions[mesh.triangles[t][k]]);
      }
      triangle[k] = vertex;
    }
  }
  return parted;
}

}  // namespace geargraph
