#include "core/presentation/scene/feature_edges.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstring>

namespace geargraph {
namespace {

constexpr std::uint32_t kNone = 0xffffffff;

/// Finds positions in a list by their contents, which the list's owner compares: open addressing, no memory a
/// find.
class Finder {
 public:
  explicit Finder(std::size_t most)
      : m_places(std::bit_ceil(2 * most + 1), kNone), m_shift(64 - std::countr_zero(m_places.size())) {}

  /// The position of the equal one, else `position`, which is noted.
  template <class IsEqual>
  std::uint32_t find(std::uint64_t contents, std::uint32_t position, IsEqual isEqual) {
    std::size_t place = (contents * 0x9e3779b97f4a7c15U) >> m_shift;
    while (m_places[place] != kNone) {
      if (isEqual(m_places[place])) return m_places[place];
      place = (place + 1) & (m_places.size() - 1);
    }
    m_places[place] = position;
    return position;
  }

 private:
  std::vector<std::uint32_t> m_places;
  int m_shift;
};

/// For every vertex the first one with the same position.
std::vector<std::uint32_t> weldedCorners(const Solid& solid) {
  Finder finder(solid.positions.size());
  std::vector<std::uint32_t> first(solid.positions.size());
  for (std::uint32_t vertex = 0; vertex < first.size(); ++vertex) {
    const Float3& here = solid.positions[vertex];
    std::array<std::uint32_t, 3> bits{};
    std::memcpy(bits.data(), here.data(), sizeof bits);
    std::uint64_t contents = bits[0];
    contents = contents * 0x9e3779b97f4a7c15U + bits[1];
    contents = contents * 0x9e3779b97f4a7c15U + bits[2];
    first[vertex] = finder.find(contents, vertex, [&](std::uint32_t other) {
      return std::memcmp(here.data(), solid.positions[other].data(), sizeof bits) == 0;
    });
  }
  return first;
}

/// An edge: the vertices as its first triangle has them, in the order of the welded points.
struct Edge {
  std::uint64_t points = 0;
  std::uint32_t low = 0;
  std::uint32_t high = 0;
  std::uint32_t next = kNone;  ///< of the same list
  bool single = true;
  bool crease = false;
};

/// How many corners of triangles lie at a point.
std::vector<std::uint32_t> cornersAt(const std::vector<std::uint32_t>& point, const Solid& solid) {
  std::vector<std::uint32_t> corners(point.size(), 0);
  for (const Triangle& triangle : solid.triangles) {
    for (const std::uint32_t corner : triangle) ++corners[point[corner]];
  }
  return corners;
}

float cosine(const Float3& a, const Float3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

}  // namespace

std::vector<std::uint32_t> featureEdges(const Solid& solid, double crease) {
  const auto flattest = static_cast<float>(std::cos(crease));
  const std::vector<std::uint32_t> point = weldedCorners(solid);
  const std::vector<std::uint32_t> corners = cornersAt(point, solid);
  std::vector<std::uint32_t> first(point.size(), kNone);  // by point: the list of its edges
  std::vector<Edge> edges;                                // in the order of first meeting
  edges.reserve(3 * solid.triangles.size() / 2 + 1);
  for (const Triangle& triangle : solid.triangles) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      std::uint32_t low = triangle[corner], high = triangle[(corner + 1) % 3];
      if (point[low] > point[high]) std::swap(low, high);
      const std::uint64_t points = (std::uint64_t{point[low]} << 32) | point[high];
      // In the list of the end where fewer edges meet: the hub of a fan has a long one.
      std::uint32_t& list = first[corners[point[high]] < corners[point[low]] ? point[high] : point[low]];
      std::uint32_t found = list;
      while (found != kNone && edges[found].points != points) found = edges[found].next;
      if (found == kNone) {
        edges.push_back({points, low, high, list});
        list = static_cast<std::uint32_t>(edges.size()) - 1;
        continue;
      }
      Edge& edge = edges[found];
      edge.single = false;
      edge.crease = edge.crease || cosine(solid.normals[low], solid.normals[edge.low]) < flattest ||
                    cosine(solid.normals[high], solid.normals[edge.high]) < flattest;
    }
  }
  std::vector<std::uint32_t> lines;
  for (const Edge& edge : edges) {
    if (edge.single || edge.crease) lines.insert(lines.end(), {edge.low, edge.high});
  }
  return lines;
}

}  // namespace geargraph
