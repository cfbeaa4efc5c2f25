#include "core/presentation/handout/page_scene.h"

#include <array>
#include <cmath>
#include <cstdio>

#include "core/foundations/files/base64.h"
#include "core/foundations/files/gzip.h"

namespace geargraph {
namespace {

using Layout = JsonWriter::Layout;

constexpr double kSteps = 65'535;          // of a coordinate
constexpr double kNormalSteps = 127;       // of half a side of the octahedron
constexpr std::size_t kMaxShort = 65'536;  // vertices that two bytes count

class Blocks {
 public:
  void number(std::uint32_t value, int bytes) {
    for (int i = 0; i < bytes; ++i) m_bytes += static_cast<char>(value >> (8 * i) & 255);
  }
  void endBlock() {
    while (m_bytes.size() % 4 != 0) m_bytes += '\0';
  }
  [[nodiscard]] const std::string& bytes() const { return m_bytes; }

 private:
  std::string m_bytes;
};

/// On the octahedron |x| + |y| + |z| = 1, its lower half folded over the sides of the upper one.
std::array<double, 2> octahedral(const Float3& normal) {
  const double x = normal[0], y = normal[1], z = normal[2];
  const double sum = std::abs(x) + std::abs(y) + std::abs(z);
  if (sum == 0) return {0, 0};
  const double u = x / sum, v = y / sum;
  if (z >= 0) return {u, v};
  return {std::copysign(1 - std::abs(v), u), std::copysign(1 - std::abs(u), v)};
}

void appendSolid(Blocks& blocks, const Solid& solid) {
  const Eigen::AlignedBox3d box = boundsOf(solid);
  for (const Float3& position : solid.positions) {
    for (int i = 0; i < 3; ++i) {
      const double side = box.max()[i] - box.min()[i];
      const double part = side > 0 ? (position[static_cast<std::size_t>(i)] - box.min()[i]) / side : 0;
      blocks.number(static_cast<std::uint32_t>(std::lround(kSteps * part)), 2);
    }
  }
  blocks.endBlock();
  for (const Float3& normal : solid.normals) {
    for (const double side : octahedral(normal))
      blocks.number(static_cast<std::uint32_t>(std::lround(kNormalSteps * side)), 1);
  }
  blocks.endBlock();
  const int bytes = solid.positions.size() > kMaxShort ? 4 : 2;
  for (const Triangle& triangle : solid.triangles) {
    for (const std::uint32_t vertex : triangle) blocks.number(vertex, bytes);
  }
  blocks.endBlock();
}

std::string hexOf(const Rgb& colour) {
  const auto byte = [](float part) { return static_cast<unsigned>(std::lround(255 * part)); };
  std::array<char, 8> text{};
  std::snprintf(text.data(), text.size(), "#%02x%02x%02x", byte(colour.red), byte(colour.green),
                byte(colour.blue));
  return text.data();
}

std::string keyOf(const ElementId& element) {
  return std::string(listName(element.kind)) + "/" + element.id.text();
}

class SceneWriter {
 public:
  SceneWriter(JsonWriter& json, const MechanismScene& stage, const Digraph& graph)
      : m_json(json), m_stage(stage), m_graph(graph) {}

  void write(double tolerance) {
    m_json.beginObject();
    m_json.member("unit", m_stage.unit);
    list("solids", m_stage.scene.solids.size(),
         [&](std::size_t i) { solid(*m_stage.scene.solidWithin(tolerance, i)); });
    list("parts", m_stage.scene.instances.size(), [&](std::size_t i) { part(m_stage.scene.instances[i]); });
    m_json.key("labels");
    m_json.beginArray();
    for (const SceneLabel& each : m_stage.labels) {
      if (each.kind == LabelKind::link) label(each);
    }
    m_json.endArray();
    m_json.endObject();
  }

 private:
  template <class Each>
  void list(std::string_view name, std::size_t size, const Each& each) {
    m_json.key(name);
    m_json.beginArray();
    for (std::size_t i = 0; i < size; ++i) {
      m_json.beginObject(Layout::row);
      each(i);
      m_json.endObject();
    }
    m_json.endArray();
  }
  void triple(std::string_view name, const Eigen::Vector3d& of) {
    m_json.key(name);
    m_json.beginArray(Layout::row);
    for (const double each : of) m_json.number(each);
    m_json.endArray();
  }

  void solid(const Solid& of) {
    const Eigen::AlignedBox3d box = boundsOf(of);
    m_json.member("vertices", of.positions.size());
    m_json.member("triangles", of.triangles.size());
    triple("low", box.min());
    triple("high", box.max());
  }

  void part(const Instance& of) {
    m_json.member("solid", of.solid);
    m_json.member("link", linkOf(of.element));
    m_json.key("pose");
    m_json.beginArray(Layout::row);
    for (int row = 0; row < 3; ++row) {
      for (const double each : Eigen::RowVector3d(of.pose.linear().row(row))) m_json.number(each);
    }
    for (const double each : Eigen::Vector3d(of.pose.translation())) m_json.number(each);
    m_json.endArray();
    m_json.member("colour", hexOf(of.colour));
    if (of.isOpen) m_json.member("open", true);
    m_json.key("elements");
    m_json.beginArray(Layout::row);
    m_json.string(keyOf(of.element));
    for (const ElementId& also : of.also) m_json.string(keyOf(also));
    m_json.endArray();
  }

  void label(const SceneLabel& of) {
    m_json.beginObject(Layout::row);
    m_json.member("text", of.text);
    m_json.member("part", of.instance);
    triple("place", of.place);
    m_json.member("radius", of.radius);
    m_json.member("colour", hexOf(of.colour));
    m_json.member("element", keyOf(of.element));
    m_json.endObject();
  }

  [[nodiscard]] int linkOf(const ElementId& element) const {
    for (int node = 0; node <= m_graph.n(); ++node) {
      if (m_graph.nodeId(node) == element) return node;
    }
    return 0;
  }

  JsonWriter& m_json;
  const MechanismScene& m_stage;
  const Digraph& m_graph;
};

}  // namespace

std::string pageGeometry(const Scene& scene, double tolerance) {
  Blocks blocks;
  for (std::size_t i = 0; i < scene.solids.size(); ++i) appendSolid(blocks, *scene.solidWithin(tolerance, i));
  return base64(gzip(blocks.bytes()));
}

void writePageScene(JsonWriter& json, const MechanismScene& stage, const Digraph& graph, double tolerance) {
  SceneWriter(json, stage, graph).write(tolerance);
}

}  // namespace geargraph
