#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <utility>

#include "core/foundations/files/json_writer.h"
#include "core/presentation/meshfile/encoders.h"
#include "core/presentation/meshfile/weld.h"

namespace geargraph::inline meshfile {
namespace {

using Layout = JsonWriter::Layout;

// Numbers of the glTF 2.0 specification.
constexpr int kFloat = 5126;
constexpr int kUnsignedInt = 5125;
constexpr int kVertices = 34962;  // ARRAY_BUFFER
constexpr int kIndices = 34963;   // ELEMENT_ARRAY_BUFFER
constexpr int kNoTarget = 0;
constexpr std::uint32_t kMagic = 0x46546C67;
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;
constexpr std::uint32_t kBinaryChunk = 0x004E4942;
constexpr float kMetallic = 0.2F;
constexpr float kRoughness = 0.5F;

struct Accessor {
  std::size_t offset = 0;
  std::size_t bytes = 0;
  std::size_t count = 0;
  int component = kFloat;
  int target = kNoTarget;
  const char* type = "VEC3";
  std::vector<float> least;  ///< required for positions and times
  std::vector<float> most;
};

/// The binary chunk, and what lies where in it.
class Buffer {
 public:
  template <class Element>
  std::size_t add(const std::vector<Element>& elements, Accessor accessor) {
    if (accessor.component == kFloat) requireFinite(elements.data(), elements.size() * sizeof(Element));
    accessor.offset = m_bytes.size();
    accessor.bytes = elements.size() * sizeof(Element);
    accessor.count = elements.size() * (sizeof(Element) / sizeof(float)) / widthOf(accessor.type);
    m_bytes.append(reinterpret_cast<const char*>(elements.data()), accessor.bytes);
    m_accessors.push_back(std::move(accessor));
    return m_accessors.size() - 1;
  }
  [[nodiscard]] const std::vector<Accessor>& accessors() const { return m_accessors; }
  [[nodiscard]] const std::string& bytes() const { return m_bytes; }

 private:
  static void requireFinite(const void* floats, std::size_t bytes) {
    for (std::size_t at = 0; at < bytes; at += sizeof(float)) {
      float number = 0;
      std::memcpy(&number, static_cast<const char*>(floats) + at, sizeof number);
      GEARGRAPH_REQUIRE(std::isfinite(number));
    }
  }
  static std::size_t widthOf(std::string_view type) { return type == "SCALAR" ? 1 : type == "VEC3" ? 3 : 4; }

  std::string m_bytes;
  std::vector<Accessor> m_accessors;
};

/// Accessors of a solid.
struct StoredSolid {
  std::size_t positions = 0;
  std::size_t normals = 0;
  std::size_t indices = 0;
};

StoredSolid store(Buffer& buffer, const Solid& solid, double scale) {
  std::vector<Float3> positions;
  positions.reserve(solid.positions.size());
  Float3 least = {INFINITY, INFINITY, INFINITY};
  Float3 most = {-INFINITY, -INFINITY, -INFINITY};
  for (const Float3& p : solid.positions) {
    Float3& scaled = positions.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      scaled[k] = static_cast<float>(p[k] * scale) + 0.0F;
      least[k] = std::min(least[k], scaled[k]);
      most[k] = std::max(most[k], scaled[k]);
    }
  }
  Accessor place{
      0, 0, 0, kFloat, kVertices, "VEC3", {least.begin(), least.end()}, {most.begin(), most.end()}};
  StoredSolid stored;
  stored.positions = buffer.add(positions, place);
  stored.normals = buffer.add(solid.normals, {0, 0, 0, kFloat, kVertices, "VEC3", {}, {}});
  stored.indices = buffer.add(solid.triangles, {0, 0, 0, kUnsignedInt, kIndices, "SCALAR", {}, {}});
  return stored;
}

/// Accessors of a node's motion.
struct StoredMotion {
  std::size_t node = 0;
  std::size_t times = 0;
  std::size_t rotations = 0;
};

std::array<float, 4> quaternionOf(const Eigen::Quaterniond& rotation) {
  const Eigen::Quaterniond q = rotation.normalized();
  return {static_cast<float>(q.x()), static_cast<float>(q.y()), static_cast<float>(q.z()),
          static_cast<float>(q.w())};
}

StoredMotion storeMotion(Buffer& buffer, const std::vector<RotationKey>& keys, std::size_t node) {
  std::vector<float> times;
  std::vector<std::array<float, 4>> rotations;
  for (const RotationKey& key : keys) {
    times.push_back(static_cast<float>(key.seconds));
    rotations.push_back(quaternionOf(key.rotation));
  }
  const std::vector<float> least{times.front()};
  const std::vector<float> most{times.back()};
  const std::size_t input = buffer.add(times, {0, 0, 0, kFloat, kNoTarget, "SCALAR", least, most});
  return {node, input, buffer.add(rotations, {0, 0, 0, kFloat, kNoTarget, "VEC4", {}, {}})};
}

float linear(float channel) {
  return channel <= 0.04045F ? channel / 12.92F : std::pow((channel + 0.055F) / 1.055F, 2.4F);
}

/// Gathers what the JSON refers to, then writes it.
class Gltf {
 public:
  Gltf(const MeshScene& scene, double scale)
      : m_scene(scene), m_scale(scale), m_children(scene.nodes.size()) {
    for (std::size_t i = 1; i < scene.nodes.size(); ++i) m_children[scene.nodes[i].parent].push_back(i);
  }

  void addNode(std::size_t place) {
    const MeshNode& node = m_scene.nodes[place];
    if (node.solid && !node.solid->empty()) {
      const auto stored = m_stored.find(node.solid.get());
      if (stored == m_stored.end()) m_stored[node.solid.get()] = store(m_buffer, *node.solid, m_scale);
      const auto [found, isNew] =
          m_meshes.try_emplace({node.solid.get(), node.material}, m_firstNodes.size());
      if (isNew) m_firstNodes.push_back(place);
      m_meshOf[place] = found->second;
    }
    if (!node.keys.empty()) m_motions.push_back(storeMotion(m_buffer, node.keys, place));
  }

  [[nodiscard]] const Buffer& buffer() const { return m_buffer; }

  [[nodiscard]] std::string json() const {
    TextSink sink;
    {
      JsonWriter out(sink);
      out.beginObject(Layout::row);
      writeAsset(out);
      out.member("scene", 0);
      out.key("scenes");
      out.json(R"([{"nodes": [0]}])");
      writeNodes(out);
      writeMaterials(out);
      if (!m_firstNodes.empty()) writeMeshes(out);
      if (!m_motions.empty()) writeAnimation(out);
      if (!m_buffer.accessors().empty()) writeBuffers(out);
      out.endObject();
    }
    return sink.text();
  }

 private:
  template <class Numbers>
  static void writeList(JsonWriter& out, std::string_view name, const Numbers& numbers) {
    out.key(name);
    out.beginArray(Layout::row);
    for (const auto number : numbers) {
      if constexpr (std::is_integral_v<std::decay_t<decltype(number)>>) {
        out.number(static_cast<std::int64_t>(number));
      } else {
        out.number(static_cast<double>(number));
      }
    }
    out.endArray();
  }

  void writeAsset(JsonWriter& out) const {
    out.key("asset");
    out.beginObject(Layout::row);
    out.member("version", "2.0");
    out.member("generator", "GearGraph");
    out.key("extras");
    out.beginObject(Layout::row);
    out.member("documentUnit", m_scene.unit);
    out.member("metresPerDocumentUnit", m_scale);
    out.endObject();
    out.endObject();
  }

  void writeNodes(JsonWriter& out) const {
    out.key("nodes");
    out.beginArray(Layout::row);
    for (std::size_t i = 0; i < m_scene.nodes.size(); ++i) {
      const MeshNode& node = m_scene.nodes[i];
      const Eigen::Vector3d origin = node.pose.translation() * m_scale;
      out.beginObject(Layout::row);
      out.member("name", node.name);
      writeList(out, "translation", std::array{origin.x() + 0.0, origin.y() + 0.0, origin.z() + 0.0});
      writeList(out, "rotation", quaternionOf(Eigen::Quaterniond(node.pose.linear())));
      if (const auto mesh = m_meshOf.find(i); mesh != m_meshOf.end()) out.member("mesh", mesh->second);
      if (!m_children[i].empty()) writeList(out, "children", m_children[i]);
      out.endObject();
    }
    out.endArray();
  }

  void writeMaterials(JsonWriter& out) const {
    if (m_scene.materials.empty()) return;
    out.key("materials");
    out.beginArray(Layout::row);
    for (const MeshMaterial& material : m_scene.materials) {
      const Float3& c = material.colour;
      out.beginObject(Layout::row);
      out.member("name", material.name);
      out.key("pbrMetallicRoughness");
      out.beginObject(Layout::row);
      writeList(out, "baseColorFactor", std::array{linear(c[0]), linear(c[1]), linear(c[2]), 1.0F});
      out.member("metallicFactor", kMetallic);
      out.member("roughnessFactor", kRoughness);
      out.endObject();
      out.endObject();
    }
    out.endArray();
  }

  void writeMeshes(JsonWriter& out) const {
    out.key("meshes");
    out.beginArray(Layout::row);
    for (const std::size_t place : m_firstNodes) {
      const MeshNode& node = m_scene.nodes[place];
      const StoredSolid& stored = m_stored.at(node.solid.get());
      out.beginObject(Layout::row);
      out.member("name", node.name);
      out.key("primitives");
      out.beginArray(Layout::row);
      out.beginObject(Layout::row);
      out.key("attributes");
      out.beginObject(Layout::row);
      out.member("POSITION", stored.positions);
      if (m_buffer.accessors()[stored.normals].count > 0) out.member("NORMAL", stored.normals);
      out.endObject();
      out.member("indices", stored.indices);
      if (node.material < m_scene.materials.size()) out.member("material", node.material);
      out.endObject();
      out.endArray();
      out.endObject();
    }
    out.endArray();
  }

  void writeAnimation(JsonWriter& out) const {
    out.key("animations");
    out.beginArray(Layout::row);
    out.beginObject(Layout::row);
    out.member("name", "motion");
    out.key("channels");
    out.beginArray(Layout::row);
    for (std::size_t i = 0; i < m_motions.size(); ++i) {
      out.json("{\"sampler\": " + std::to_string(i) + ", \"target\": {\"node\": " +
               std::to_string(m_motions[i].node) + ", \"path\": \"rotation\"}}");
    }
    out.endArray();
    out.key("samplers");
    out.beginArray(Layout::row);
    for (const StoredMotion& motion : m_motions) {
      out.json("{\"input\": " + std::to_string(motion.times) +
               ", \"interpolation\": \"LINEAR\", \"output\": " + std::to_string(motion.rotations) + "}");
    }
    out.endArray();
    out.endObject();
    out.endArray();
  }

  void writeBuffers(JsonWriter& out) const {
    out.key("accessors");
    out.beginArray(Layout::row);
    for (std::size_t i = 0; i < m_buffer.accessors().size(); ++i) {
      const Accessor& accessor = m_buffer.accessors()[i];
      out.beginObject(Layout::row);
      out.member("bufferView", i);
      out.member("componentType", accessor.component);
      out.member("count", accessor.count);
      out.member("type", accessor.type);
      if (!accessor.least.empty()) {
        writeList(out, "min", accessor.least);
        writeList(out, "max", accessor.most);
      }
      out.endObject();
    }
    out.endArray();
    out.key("bufferViews");
    out.beginArray(Layout::row);
    for (const Accessor& accessor : m_buffer.accessors()) {
      out.beginObject(Layout::row);
      out.member("buffer", 0);
      out.member("byteOffset", accessor.offset);
      out.member("byteLength", accessor.bytes);
      if (accessor.target != kNoTarget) out.member("target", accessor.target);
      out.endObject();
    }
    out.endArray();
    out.key("buffers");
    out.json("[{\"byteLength\": " + std::to_string(m_buffer.bytes().size()) + "}]");
  }

  const MeshScene& m_scene;
  double m_scale;
  std::vector<std::vector<std::size_t>> m_children;
  Buffer m_buffer;
  std::map<const Solid*, StoredSolid> m_stored;
  std::map<std::pair<const Solid*, std::size_t>, std::size_t> m_meshes;
  std::vector<std::size_t> m_firstNodes;  ///< of each mesh
  std::map<std::size_t, std::size_t> m_meshOf;
  std::vector<StoredMotion> m_motions;
};

std::string container(std::string json, const std::string& binary) {
  while (json.size() % 4 != 0) json += ' ';
  constexpr std::size_t kHeader = 12;
  constexpr std::size_t kChunkHeader = 8;
  const std::size_t length =
      kHeader + kChunkHeader + json.size() + (binary.empty() ? 0 : kChunkHeader + binary.size());
  std::string bytes;
  bytes.reserve(length);
  appendRaw(bytes, kMagic);
  appendRaw(bytes, std::uint32_t{2});
  appendRaw(bytes, static_cast<std::uint32_t>(length));
  appendRaw(bytes, static_cast<std::uint32_t>(json.size()));
  appendRaw(bytes, kJsonChunk);
  bytes += json;
  if (binary.empty()) return bytes;
  appendRaw(bytes, static_cast<std::uint32_t>(binary.size()));  // whole numbers of four bytes, all of it
  appendRaw(bytes, kBinaryChunk);
  return bytes += binary;
}

}  // namespace

std::optional<std::string> glbBytes(const MeshScene& scene, const MeshWriteOptions& options) {
  const MeshScene rooted = withDistinctNames(withRoot(scene));
  Gltf gltf(rooted, metresPerUnit(scene.unit));
  for (std::size_t i = 0; i < rooted.nodes.size(); ++i) {
    if (!mayGoOn(options, i, rooted.nodes.size())) return std::nullopt;
    gltf.addNode(i);
  }
  return container(gltf.json(), gltf.buffer().bytes());
}

}  // namespace geargraph::inline meshfile
