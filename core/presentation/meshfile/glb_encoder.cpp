#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <utility>

#include "core/foundations/files/byte_sink.h"
#include "core/foundations/files/json_writer.h"
#include "core/presentation/meshfile/encoders.h"
#include "core/presentation/meshfile/weld.h"

namespace geargraph {
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

/// The binary chunk: where everything is in it, and how each piece is written when its turn comes. Nothing of
/// it is held in memory.
class Buffer {
 public:
  using Write = std::function<void(BufferedSink&)>;

  /// Elements of numbers of four bytes each, which `write` writes.
  std::size_t add(std::size_t elements, Accessor accessor, Write write) {
    accessor.offset = m_bytes;
    accessor.bytes = elements * widthOf(accessor.type) * sizeof(float);
    accessor.count = elements;
    m_bytes += accessor.bytes;
    m_accessors.push_back(std::move(accessor));
    m_writes.push_back(std::move(write));
    return m_accessors.size() - 1;
  }
  [[nodiscard]] const std::vector<Accessor>& accessors() const { return m_accessors; }
  [[nodiscard]] std::size_t bytes() const { return m_bytes; }

  /// False where it was stopped.
  [[nodiscard]] bool writeTo(ByteSink& sink, const MeshWriteOptions& options) const {
    BufferedSink out(sink);
    for (std::size_t i = 0; i < m_writes.size() && !sink.failed(); ++i) {
      if (!reportProgress(options, i, m_writes.size())) return false;
      m_writes[i](out);
    }
    return !options.stop.stop_requested();
  }

 private:
  static std::size_t widthOf(std::string_view type) { return type == "SCALAR" ? 1 : type == "VEC3" ? 3 : 4; }

  std::size_t m_bytes = 0;
  std::vector<Accessor> m_accessors;
  std::vector<Write> m_writes;
};

template <class Value>
void writeRaw(BufferedSink& out, const Value& value) {
  static_assert(std::is_trivially_copyable_v<Value>);
  out.write({reinterpret_cast<const char*>(&value), sizeof value});
}

/// Accessors of a solid.
struct StoredSolid {
  std::size_t positions = 0;
  std::size_t normals = 0;
  std::size_t indices = 0;
};

Float3 scaled(const Float3& point, double scale) {
  Float3 result{};
  for (std::size_t k = 0; k < 3; ++k) result[k] = static_cast<float>(point[k] * scale) + 0.0F;
  return result;
}

StoredSolid store(Buffer& buffer, const Solid& solid, double scale) {
  Float3 least = {INFINITY, INFINITY, INFINITY};
  Float3 most = {-INFINITY, -INFINITY, -INFINITY};
  for (const Float3& point : solid.positions) {
    const Float3 p = scaled(finite(point), scale);
    for (std::size_t k = 0; k < 3; ++k) {
      least[k] = std::min(least[k], p[k]);
      most[k] = std::max(most[k], p[k]);
    }
  }
  Accessor place{
      0, 0, 0, kFloat, kVertices, "VEC3", {least.begin(), least.end()}, {most.begin(), most.end()}};
  StoredSolid stored;
  stored.positions = buffer.add(solid.positions.size(), std::move(place), [&solid, scale](BufferedSink& out) {
    for (const Float3& point : solid.positions) writeRaw(out, scaled(point, scale));
  });
  stored.normals = buffer.add(solid.normals.size(), {0, 0, 0, kFloat, kVertices, "VEC3", {}, {}},
                              [&solid](BufferedSink& out) {
                                for (const Float3& normal : solid.normals) writeRaw(out, finite(normal));
                              });
  stored.indices = buffer.add(3 * solid.triangles.size(), {0, 0, 0, kUnsignedInt, kIndices, "SCALAR", {}, {}},
                              [&solid](BufferedSink& out) {
                                out.write({reinterpret_cast<const char*>(solid.triangles.data()),
                                           solid.triangles.size() * sizeof(Triangle)});
                              });
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
  const std::vector<float> least{static_cast<float>(keys.front().seconds)};
  const std::vector<float> most{static_cast<float>(keys.back().seconds)};
  const std::size_t times = buffer.add(keys.size(), {0, 0, 0, kFloat, kNoTarget, "SCALAR", least, most},
                                       [&keys](BufferedSink& out) {
                                         for (const RotationKey& key : keys)
                                           writeRaw(out, static_cast<float>(key.seconds));
                                       });
  const std::size_t rotations =
      buffer.add(keys.size(), {0, 0, 0, kFloat, kNoTarget, "VEC4", {}, {}}, [&keys](BufferedSink& out) {
        for (const RotationKey& key : keys) writeRaw(out, quaternionOf(key.rotation));
      });
  return {node, times, rotations};
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
    out.json("[{\"byteLength\": " + std::to_string(m_buffer.bytes()) + "}]");
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

}  // namespace

bool writeGlb(const MeshScene& scene, const MeshWriteOptions& options, ByteSink& sink) {
  const MeshScene rooted = withDistinctNames(withRoot(scene));
  Gltf gltf(rooted, metresPerUnit(scene.unit));
  for (std::size_t i = 0; i < rooted.nodes.size(); ++i) {
    if (options.stop.stop_requested()) return false;
    gltf.addNode(i);
  }
  std::string json = gltf.json();
  while (json.size() % 4 != 0) json += ' ';
  const std::size_t binary = gltf.buffer().bytes();  // whole numbers of four bytes, all of it
  constexpr std::size_t kHeader = 12;
  constexpr std::size_t kChunkHeader = 8;
  const std::size_t length = kHeader + kChunkHeader + json.size() + (binary == 0 ? 0 : kChunkHeader + binary);
  std::string head;
  appendRaw(head, kMagic);
  appendRaw(head, std::uint32_t{2});
  appendRaw(head, static_cast<std::uint32_t>(length));
  appendRaw(head, static_cast<std::uint32_t>(json.size()));
  appendRaw(head, kJsonChunk);
  sink.write(head);
  sink.write(json);
  if (binary == 0) return !options.stop.stop_requested();
  head.clear();
  appendRaw(head, static_cast<std::uint32_t>(binary));
  appendRaw(head, kBinaryChunk);
  sink.write(head);
  return gltf.buffer().writeTo(sink, options);
}

}  // namespace geargraph
