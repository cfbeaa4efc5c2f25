#include "core/render/feature_edges.h"

#include <array>
#include <cmath>
#include <cstring>
#include <unordered_map>

namespace geargraph {
namespace {

struct Bits {
  std::array<std::uint32_t, 3> words;
  friend bool operator==(const Bits&, const Bits&) = default;
};

struct BitsHash {
  std::size_t operator()(const Bits& bits) const {
    std::uint64_t hash = bits.words[0];
    hash = hash * 0x9e3779b97f4a7c15u + bits.words[1];
    hash = hash * 0x9e3779b97f4a7c15u + bits.words[2];
    return hash ^ (hash >> 29);
  }
};

/// For every vertex the first one with the same position.
std::vector<std::uint32_t> welded(const Solid& solid) {
  std::unordered_map<Bits, std::uint32_t, BitsHash> first;
  first.reserve(solid.positions.size());
  std::vector<std::uint32_t> result(solid.positions.size());
  for (std::uint32_t vertex = 0; vertex < result.size(); ++vertex) {
    Bits bits;
    std::memcpy(bits.words.data(), solid.positions[vertex].data(), sizeof bits.words);
    result[vertex] = first.try_emplace(bits, vertex).first->second;
  }
  return result;
}

/// One side of an edge: the vertices as its triangle has them, in the order of the welded points.
struct Side {
  std::uint32_t low = 0;
  std::uint32_t high = 0;
  int faces = 0;
  bool crease = false;
};

float cosine(const Float3& a, const Float3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

}  // namespace

std::vector<std::uint32_t> featureEdges(const Solid& solid, double crease) {
  const auto flattest = static_cast<float>(std::cos(crease));
  const std::vector<std::uint32_t> point = welded(solid);
  std::unordered_map<std::uint64_t, Side> edges;
  edges.reserve(2 * solid.triangles.size());
  std::vector<std::uint64_t> order;  // of first meeting: the result must not depend on the hash
  for (const Triangle& triangle : solid.triangles) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      std::uint32_t low = triangle[corner], high = triangle[(corner + 1) % 3];
      if (point[low] > point[high]) std::swap(low, high);
      const std::uint64_t key = (std::uint64_t{point[low]} << 32) | point[high];
      Side& side = edges[key];
      if (side.faces++ == 0) {
        side.low = low;
        side.high = high;
        order.push_back(key);
      } else {
        side.crease = side.crease || cosine(solid.normals[low], solid.normals[side.low]) < flattest ||
                      cosine(solid.normals[high], solid.normals[side.high]) < flattest;
      }
    }
  }
  std::vector<std::uint32_t> lines;
  for (const std::uint64_t key : order) {
    const Side& side = edges.at(key);
    if (side.faces == 1 || side.crease) lines.insert(lines.end(), {side.low, side.high});
  }
  return lines;
}

}  // namespace geargraph
