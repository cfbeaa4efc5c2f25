#include "core/presentation/meshfile/encoders.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "core/foundations/base/text_lists.h"
#include "core/presentation/meshfile/weld.h"
#include "core/presentation/meshfile/zip_archive.h"

namespace geargraph {
namespace {

constexpr std::string_view kContentTypes =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">
 <Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>
 <Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/>
</Types>
)";
constexpr std::string_view kRelationships =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">
 <Relationship Target="/3D/3dmodel.model" Id="rel0" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/>
</Relationships>
)";
constexpr int kMaterialsId = 1;  // objects follow

std::string hexColour(const Float3& colour) {
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  std::string text = "#";
  for (const float channel : colour) {
    const auto byte = static_cast<unsigned>(std::lround(std::clamp(channel, 0.0F, 1.0F) * 255));
    text += kDigits[byte >> 4U];
    text += kDigits[byte & 15U];
  }
  return text;
}

/// The unit's name in 3MF. Units that it does not have are written in millimetres.
std::pair<std::string_view, double> unitOf(const std::string& unit) {
  static constexpr std::array<std::pair<std::string_view, double>, 6> kUnits{{{"micron", 1e-6},
                                                                              {"millimeter", 1e-3},
                                                                              {"centimeter", 1e-2},
                                                                              {"inch", 0.0254},
                                                                              {"foot", 0.3048},
                                                                              {"meter", 1}}};
  const double metres = metresPerUnit(unit);
  for (const auto& known : kUnits) {
    if (known.second == metres) return {known.first, 1};
  }
  return {"millimeter", metres / 1e-3};
}

std::string headOf(const MeshScene& scene) {
  std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<model unit=\"";
  text += unitOf(scene.unit).first;
  text += "\" xml:lang=\"en-US\" xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\">\n";
  text += " <metadata name=\"Title\">" + escapedXml(scene.name) + "</metadata>\n";
  text += " <metadata name=\"Application\">GearGraph</metadata>\n <resources>\n";
  if (scene.materials.empty()) return text;
  text += "  <basematerials id=\"" + std::to_string(kMaterialsId) + "\">\n";
  for (const MeshMaterial& material : scene.materials) {
    text += "   <base name=\"" + escapedXml(material.name) + "\" displaycolor=\"" +
            hexColour(material.colour) + "\"/>\n";
  }
  return text + "  </basematerials>\n";
}

std::string objectOf(const MeshScene& scene, const MeshNode& node, int id) {
  const WeldedMesh mesh = weldedToManifold(*node.solid);
  std::string text =
      "  <object id=\"" + std::to_string(id) + "\" type=\"model\" name=\"" + escapedXml(node.name);
  if (!scene.materials.empty()) {
    text += "\" pid=\"" + std::to_string(kMaterialsId) + "\" pindex=\"" + std::to_string(node.material);
  }
  text += "\">\n   <mesh>\n    <vertices>\n";
  for (const Float3& p : mesh.positions) {
    text += "     <vertex x=\"";
    appendDecimal(text, p[0]);
    text += "\" y=\"";
    appendDecimal(text, p[1]);
    text += "\" z=\"";
    appendDecimal(text, p[2]);
    text += "\"/>\n";
  }
  text += "    </vertices>\n    <triangles>\n";
  for (const Triangle& t : mesh.triangles) {
    text += "     <triangle v1=\"";
    appendDecimal(text, t[0]);
    text += "\" v2=\"";
    appendDecimal(text, t[1]);
    text += "\" v3=\"";
    appendDecimal(text, t[2]);
    text += "\"/>\n";
  }
  return text + "    </triangles>\n   </mesh>\n  </object>\n";
}

/// 3MF multiplies rows from the left, so the columns of our matrix come one after the other.
std::string itemOf(const Eigen::Isometry3d& pose, double scale, int id) {
  std::string text = "  <item objectid=\"" + std::to_string(id) + "\" transform=\"";
  for (Eigen::Index column = 0; column < 4; ++column) {
    for (Eigen::Index row = 0; row < 3; ++row) {
      if (row + column > 0) text += ' ';
      appendDecimal(text, pose.matrix()(row, column) * scale + 0.0);
    }
  }
  return text + "\"/>\n";
}

}  // namespace

std::optional<std::string> threeMfBytes(const MeshScene& scene, const MeshWriteOptions& options) {
  ZipArchive archive;
  archive.beginEntry("[Content_Types].xml");
  archive.write(kContentTypes);
  archive.endEntry();
  archive.beginEntry("_rels/.rels");
  archive.write(kRelationships);
  archive.endEntry();

  archive.beginEntry("3D/3dmodel.model");
  archive.write(headOf(scene));
  const std::vector<Eigen::Isometry3d> world = worldPoses(scene);
  const double scale = unitOf(scene.unit).second;
  std::string items;
  int id = kMaterialsId;
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    if (!reportProgress(options, i, scene.nodes.size())) return std::nullopt;
    if (!scene.nodes[i].solid || scene.nodes[i].solid->empty()) continue;
    archive.write(objectOf(scene, scene.nodes[i], ++id));
    items += itemOf(world[i], scale, id);
  }
  archive.write(" </resources>\n <build>\n" + items + " </build>\n</model>\n");
  archive.endEntry();
  return archive.finish();
}

}  // namespace geargraph
