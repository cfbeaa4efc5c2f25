#include "core/presentation/meshfile/encoders.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "core/presentation/meshfile/weld.h"

namespace geargraph {
namespace {

constexpr std::size_t kHeaderSize = 80;
constexpr std::size_t kFacetSize = 50;

static_assert(std::endian::native == std::endian::little, "numbers are written as the machine holds them");

Float3 facetNormal(const Float3& a, const Float3& b, const Float3& c) {
  const Eigen::Vector3d p(a[0], a[1], a[2]);
  const Eigen::Vector3d n =
      (Eigen::Vector3d(b[0], b[1], b[2]) - p).cross(Eigen::Vector3d(c[0], c[1], c[2]) - p);
  const double length = n.norm();
  if (!(length > 0)) return {0, 0, 0};
  return withoutNegativeZeros({static_cast<float>(n.x() / length), static_cast<float>(n.y() / length),
                               static_cast<float>(n.z() / length)});
}

void appendFacet(std::string& bytes, const Solid& solid, const Triangle& triangle) {
  std::array<Float3, 4> facet;
  for (std::size_t k = 0; k < 3; ++k)
    facet[k + 1] = finite(withoutNegativeZeros(solid.positions[triangle[k]]));
  facet[0] = finite(facetNormal(facet[1], facet[2], facet[3]));
  std::array<char, kFacetSize> record{};  // two bytes of attributes stay 0
  std::memcpy(record.data(), facet.data(), sizeof facet);
  bytes.append(record.data(), record.size());
}

std::string plyHeader(const MeshScene& flat, std::size_t vertices) {
  std::string header = "ply\nformat binary_little_endian 1.0\ncomment GearGraph, unit " +
                       flat.unit.substr(0, 16) + "\nelement vertex " + std::to_string(vertices) + "\n";
  for (const char* name : {"x", "y", "z", "nx", "ny", "nz"}) {
    header += std::string("property float ") + name + "\n";
  }
  for (const char* name : {"red", "green", "blue"}) header += std::string("property uchar ") + name + "\n";
  return header + "element face " + std::to_string(triangleCount(flat)) +
         "\nproperty list uchar uint vertex_indices\nend_header\n";
}

std::array<std::uint8_t, 3> bytesOf(const Float3& colour) {
  std::array<std::uint8_t, 3> bytes{};
  for (std::size_t k = 0; k < 3; ++k) {
    bytes[k] = static_cast<std::uint8_t>(std::lround(std::clamp(colour[k], 0.0F, 1.0F) * 255));
  }
  return bytes;
}

void appendVertices(std::string& bytes, const Solid& solid, const std::array<std::uint8_t, 3>& colour) {
  for (std::size_t i = 0; i < solid.positions.size(); ++i) {
    appendRaw(bytes, finite(withoutNegativeZeros(solid.positions[i])));
    appendRaw(bytes, finite(solid.normals[i]));
    appendRaw(bytes, colour);
  }
}

}  // namespace

std::optional<std::string> stlBytes(const MeshScene& scene, const MeshWriteOptions& options) {
  const MeshScene flat = flattened(scene);
  const auto count = static_cast<std::uint32_t>(triangleCount(flat));
  // A binary file must not begin with "solid": readers would take it for text.
  std::string bytes = unitNote(flat);
  bytes.resize(kHeaderSize, '\0');
  bytes.reserve(kHeaderSize + sizeof count + count * kFacetSize);
  appendRaw(bytes, count);
  for (std::size_t i = 0; i < flat.nodes.size(); ++i) {
    if (!reportProgress(options, i, flat.nodes.size())) return std::nullopt;
    const Solid& solid = *flat.nodes[i].solid;
    for (const Triangle& triangle : solid.triangles) appendFacet(bytes, solid, triangle);
  }
  return bytes;
}

std::optional<std::string> plyBytes(const MeshScene& scene, const MeshWriteOptions& options) {
  const MeshScene flat = flattened(scene);
  std::size_t vertices = 0;
  for (const MeshNode& node : flat.nodes) vertices += node.solid->positions.size();

  std::string bytes = plyHeader(flat, vertices);
  std::string faces;
  std::uint32_t first = 0;
  for (std::size_t i = 0; i < flat.nodes.size(); ++i) {
    if (!reportProgress(options, i, flat.nodes.size())) return std::nullopt;
    const Solid& solid = *flat.nodes[i].solid;
    appendVertices(bytes, solid, bytesOf(colourOf(flat, flat.nodes[i])));
    for (const Triangle& t : solid.triangles) {
      appendRaw(faces, std::uint8_t{3});
      appendRaw(faces, Triangle{t[0] + first, t[1] + first, t[2] + first});
    }
    first += static_cast<std::uint32_t>(solid.positions.size());
  }
  return bytes + faces;
}

}  // namespace geargraph
