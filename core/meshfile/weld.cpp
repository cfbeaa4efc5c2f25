#include "core/meshfile/weld.h"

#include <bit>
#include <cstdint>
#include <unordered_map>

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

}  // namespace geargraph
