#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

#include "core/foundations/base/contract.h"
#include "core/foundations/files/byte_sink.h"
#include "core/presentation/meshfile/mesh_writer.h"

namespace geargraph {

// One encoder per format. Each returns std::nullopt if `stop` was requested; that of GLB writes to a sink.
// They are our own code, because assimp 5.2 drops node transforms that differ from the identity by less than
// 0.01 and joins vertices nearer than 1e-5 (GLB, where lengths are metres), cannot read back the colours of
// its own PLY, writes 3MF without colours, unit and names, and gives the facets of STL a mean of shading
// normals. It reads all five back in the tests.

/// Binary STL of the scene at rest; the normal of each facet is that of its plane.
[[nodiscard]] std::optional<std::string> stlBytes(const MeshScene& scene, const MeshWriteOptions& options);

/// Binary PLY of the scene at rest, each vertex with its normal and its material's colour.
[[nodiscard]] std::optional<std::string> plyBytes(const MeshScene& scene, const MeshWriteOptions& options);

/// Wavefront OBJ of the scene at rest, one object per solid, positions welded, normals kept; and its
/// materials.
struct ObjTexts {
  std::string scene;
  std::string materials;
};
[[nodiscard]] std::optional<ObjTexts> objTexts(const MeshScene& scene, const std::string& materialsFile,
                                               const MeshWriteOptions& options);

/// Binary glTF 2.0: the tree of nodes below one with the scene's name, lengths in metres, one animation.
/// Shared solids are stored once. Nodes get distinct names, because readers identify animated nodes by name.
/// False if `stop` was requested. Memory: independent of the size of the solids, which are read twice, for
/// their bounds and for their bytes.
[[nodiscard]] bool writeGlb(const MeshScene& scene, const MeshWriteOptions& options, ByteSink& sink);

/// A 3MF package [3MF Core Specification 1.3]: an object for each node with a solid, welded as 3MF requires,
/// named and coloured, placed at rest by its build item.
[[nodiscard]] std::optional<std::string> threeMfBytes(const MeshScene& scene,
                                                      const MeshWriteOptions& options);

/// To be called before piece `place` of `count`: reports progress; false if `stop` was requested.
[[nodiscard]] inline bool reportProgress(const MeshWriteOptions& options, std::size_t place,
                                         std::size_t count) {
  if (options.stop.stop_requested()) return false;
  if (options.progress) options.progress(static_cast<double>(place) / static_cast<double>(count));
  return true;
}

/// Appends the bytes of the value as in memory.
template <class Value>
void appendRaw(std::string& bytes, const Value& value) {
  static_assert(std::is_trivially_copyable_v<Value>);
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

/// Returns the point after checking that it is finite. @pre finite: encodedMesh() rejects other scenes
[[nodiscard]] inline const Float3& finite(const Float3& point) {
  GEARGRAPH_REQUIRE(std::isfinite(point[0]) && std::isfinite(point[1]) && std::isfinite(point[2]));
  return point;
}

/// Appends the shortest decimal that reads back as the same number. @pre finite
template <class Number>
void appendDecimal(std::string& text, Number value) {
  if constexpr (std::is_floating_point_v<Number>) GEARGRAPH_REQUIRE(std::isfinite(value));
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  text.append(digits.data(), end);
}

/// Colour of a node's material; a neutral grey where the scene has no such material.
[[nodiscard]] inline Float3 colourOf(const MeshScene& scene, const MeshNode& node) {
  return node.material < scene.materials.size() ? scene.materials[node.material].colour
                                                : MeshMaterial{}.colour;
}

/// "unit mm", for the comment of a file.
[[nodiscard]] inline std::string unitNote(const MeshScene& scene) {
  return "GearGraph, unit " + scene.unit.substr(0, 16);
}

/// The text in one line.
[[nodiscard]] inline std::string inOneLine(std::string text) {
  for (char& c : text) c = static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  return text;
}

}  // namespace geargraph
