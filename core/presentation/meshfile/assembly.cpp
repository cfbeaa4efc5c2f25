#include "core/presentation/meshfile/assembly.h"

#include <numbers>
#include <set>

#include "core/foundations/base/contract.h"
#include "core/foundations/files/folder.h"
#include "core/foundations/files/json_writer.h"
#include "core/machine/teeth/wheel_kind.h"

namespace geargraph {
namespace {

namespace fs = std::filesystem;
using Layout = JsonWriter::Layout;

constexpr std::string_view kIndexFile = "assembly.json";
constexpr double kDegrees = 180 / std::numbers::pi;

void writePose(JsonWriter& out, const Eigen::Isometry3d& pose) {
  out.beginArray(Layout::row);
  for (Eigen::Index row = 0; row < 4; ++row) {
    out.beginArray(Layout::row);
    for (Eigen::Index column = 0; column < 4; ++column) out.number(pose.matrix()(row, column) + 0.0);
    out.endArray();
  }
  out.endArray();
}

void writeOptional(JsonWriter& out, std::string_view name, const std::optional<double>& value) {
  if (value) out.member(name, *value);
}

void writeGear(JsonWriter& out, const AssemblyGear& gear, const std::string& file) {
  out.beginObject();
  out.member("name", gear.name);
  out.member("file", file);
  out.member("type", gearKindName(gear.kind));
  out.member("z", gear.teeth);
  out.member("module", gear.module);
  out.member("alpha_deg", gear.pressureAngle * kDegrees);
  out.member("x", gear.profileShift);
  if (wheelKind(gear.kind).isConical) {
    out.member("face", gear.width);
    out.member("delta_deg", gear.coneAngle * kDegrees);
    out.member("flank", "spherical_involute");
  } else {
    out.member("width", gear.width);
  }
  if (gear.helixAngle != 0) {
    out.member("beta_deg", gear.helixAngle * kDegrees);
    out.key("herringbone");
    out.json(gear.herringbone ? "true" : "false");
  }
  out.member("bore", gear.bore);
  out.member("thinning", gear.backlashAllowance);
  writeOptional(out, "ha", gear.addendum);
  writeOptional(out, "hf", gear.dedendum);
  writeOptional(out, "rho", gear.rootRadius);
  writeOptional(out, "ra", gear.tipCircle);
  writeOptional(out, "rf", gear.rootCircle);
  out.key("pose");
  writePose(out, gear.pose);
  out.endObject();
}

std::variant<FolderFiles, MeshFileError> encodedFiles(const Assembly& assembly,
                                                      const MeshWriteOptions& options) {
  FolderFiles files;
  MeshWriteOptions each = options;
  each.progress = {};
  const std::vector<std::string> names = gearFiles(assembly);
  for (std::size_t i = 0; i < names.size(); ++i) {
    const AssemblyGear& gear = assembly.gears[i];
    if (options.progress) options.progress(0.5 * static_cast<double>(i) / static_cast<double>(names.size()));
    MeshScene scene{gear.name, assembly.unit, {}, {}};
    scene.nodes.emplace_back().solid = gear.solid;
    auto encoded = encodedMesh(scene, MeshFormat::stl, gear.name, each);
    if (const auto* error = std::get_if<MeshFileError>(&encoded)) return *error;
    auto& stl = std::get<std::vector<EncodedFile>>(encoded).front();
    each.mostTriangles -= gear.solid->triangles.size();  // the limit is one for all
    files.emplace_back(names[i], std::move(stl.bytes));
  }
  files.emplace_back(kIndexFile, assemblyJson(assembly));
  return files;
}

}  // namespace

std::vector<std::string> gearFiles(const Assembly& assembly) {
  std::set<std::string> taken;
  std::vector<std::string> names;
  for (const AssemblyGear& gear : assembly.gears) {
    std::string stem;
    for (const char c : gear.name) {
      const bool isSafe = (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
      stem += isSafe || c == '_' ? c : '-';
    }
    if (stem.size() > 100 || stem.empty()) stem = "gear";
    std::string name = stem;
    for (int i = 2; !taken.insert(name).second; ++i) name = stem + "_" + std::to_string(i);
    names.push_back(name + ".stl");
  }
  return names;
}

std::string assemblyJson(const Assembly& assembly) {
  TextSink sink;
  {
    JsonWriter out(sink);
    const std::vector<std::string> files = gearFiles(assembly);
    out.beginObject();
    out.member("unit", assembly.unit);
    out.key("gears");
    out.beginArray();
    for (std::size_t i = 0; i < assembly.gears.size(); ++i) writeGear(out, assembly.gears[i], files[i]);
    out.endArray();
    out.key("meshes");
    out.beginArray();
    for (const AssemblyPair& pair : assembly.meshes) {
      out.beginObject(Layout::row);
      out.member("a", assembly.gears[pair.a].name);
      out.member("b", assembly.gears[pair.b].name);
      out.endObject();
    }
    out.endArray();
    out.key("frames");
    out.beginArray();
    for (const auto& frame : assembly.frames) {
      GEARGRAPH_REQUIRE(frame.size() == assembly.gears.size());
      out.beginObject();
      for (std::size_t i = 0; i < frame.size(); ++i) {
        out.key(assembly.gears[i].name);
        writePose(out, frame[i]);
      }
      out.endObject();
    }
    out.endArray();
    out.endObject();
  }
  return sink.take() + "\n";
}

std::optional<MeshFileError> writeAssembly(const Assembly& assembly, const fs::path& folder, bool overwrite,
                                           const MeshWriteOptions& options) {
  const auto encoded = encodedFiles(assembly, options);
  if (const auto* error = std::get_if<MeshFileError>(&encoded)) return *error;
  FolderOptions into{overwrite, options.stop, {}};
  if (options.progress) into.progress = [&](double part) { options.progress(0.5 + 0.5 * part); };
  const auto error = writeFolder(folder, std::get<FolderFiles>(encoded), into);
  if (!error) return std::nullopt;
  return MeshFileError{error->isStopped ? MeshFileError::Kind::stopped : MeshFileError::Kind::file,
                       error->message};
}

}  // namespace geargraph
