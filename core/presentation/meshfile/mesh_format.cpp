#include "core/presentation/meshfile/mesh_format.h"

namespace geargraph {

std::string_view meshFormatName(MeshFormat format) {
  switch (format) {
    case MeshFormat::stl:
      return "stl";
    case MeshFormat::obj:
      return "obj";
    case MeshFormat::ply:
      return "ply";
    case MeshFormat::glb:
      return "glb";
    case MeshFormat::threeMf:
      return "3mf";
  }
  return {};
}

const std::vector<MeshFormat>& allMeshFormats() {
  static const std::vector<MeshFormat> formats{MeshFormat::stl, MeshFormat::obj, MeshFormat::ply,
                                               MeshFormat::glb, MeshFormat::threeMf};
  return formats;
}

std::optional<MeshFormat> meshFormatFromName(std::string_view name) {
  for (const MeshFormat format : allMeshFormats()) {
    if (meshFormatName(format) == name) return format;
  }
  return std::nullopt;
}

bool carriesAnimation(MeshFormat format) {
  return format == MeshFormat::glb;
}

}  // namespace geargraph
