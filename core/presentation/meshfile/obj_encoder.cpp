#include <map>

#include "core/presentation/meshfile/encoders.h"
#include "core/presentation/meshfile/weld.h"

namespace geargraph {
namespace {

void appendPoint(std::string& text, const char* keyword, const Float3& p) {
  text += keyword;
  for (const float coordinate : p) {
    text += ' ';
    appendDecimal(text, coordinate);
  }
  text += '\n';
}

/// Lines of one kind ("v", "vn"), each once; OBJ counts them from 1 through the whole file.
class PointTable {
 public:
  PointTable(const char* keyword, std::size_t& count) : m_keyword(keyword), m_count(count) {}

  std::size_t placeOf(const Float3& point) {
    const Float3 clean = withoutNegativeZeros(point);
    const auto [found, isNew] = m_places.try_emplace(clean, m_count + 1);
    if (isNew) {
      ++m_count;
      appendPoint(m_lines, m_keyword, clean);
    }
    return found->second;
  }
  [[nodiscard]] const std::string& lines() const { return m_lines; }

 private:
  const char* m_keyword;
  std::size_t& m_count;
  std::map<Float3, std::size_t> m_places;
  std::string m_lines;
};

struct Counts {
  std::size_t positions = 0;
  std::size_t normals = 0;
};

std::string objectOf(const Solid& solid, Counts& counts) {
  PointTable positions("v", counts.positions);
  PointTable normals("vn", counts.normals);
  std::vector<std::string> corners(solid.positions.size());
  for (std::size_t i = 0; i < corners.size(); ++i) {
    corners[i] += ' ';
    appendDecimal(corners[i], positions.placeOf(solid.positions[i]));
    if (i >= solid.normals.size()) continue;
    corners[i] += "//";
    appendDecimal(corners[i], normals.placeOf(solid.normals[i]));
  }
  std::string text = positions.lines() + normals.lines();
  for (const Triangle& t : solid.triangles) {
    text += 'f';
    for (const std::uint32_t corner : t) text += corners[corner];
    text += '\n';
  }
  return text;
}

std::string materialsOf(const MeshScene& scene) {
  std::string text = "# GearGraph\n";
  for (const MeshMaterial& material : scene.materials) {
    text += "newmtl " + inOneLine(material.name) + "\n";
    appendPoint(text, "Kd", material.colour);
    text += "illum 1\n";
  }
  return text;
}

}  // namespace

std::optional<ObjTexts> objTexts(const MeshScene& scene, const std::string& materialsFile,
                                 const MeshWriteOptions& options) {
  const MeshScene flat = withDistinctNames(flattened(scene));
  std::string text = "# " + inOneLine(unitNote(flat)) + "\nmtllib " + inOneLine(materialsFile) + "\n";
  Counts counts;
  for (std::size_t i = 0; i < flat.nodes.size(); ++i) {
    if (!reportProgress(options, i, flat.nodes.size())) return std::nullopt;
    const MeshNode& node = flat.nodes[i];
    const std::string name = inOneLine(node.name);
    text += "o " + name + "\ng " + name + "\n";  // some readers look at one, some at the other
    if (node.material < flat.materials.size()) {
      text += "usemtl " + inOneLine(flat.materials[node.material].name) + "\n";
    }
    text += objectOf(*node.solid, counts);
  }
  return ObjTexts{std::move(text), materialsOf(flat)};
}

}  // namespace geargraph
