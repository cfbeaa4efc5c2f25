#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace geargraph {

enum class MeshFormat { stl, obj, ply, glb, threeMf };

/// "stl", "obj", "ply", "glb", "3mf": as on the command line and in file extensions.
[[nodiscard]] std::string_view meshFormatName(MeshFormat format);
[[nodiscard]] std::optional<MeshFormat> meshFormatFromName(std::string_view name);
[[nodiscard]] const std::vector<MeshFormat>& allMeshFormats();

/// Only GLB carries motion.
[[nodiscard]] bool carriesAnimation(MeshFormat format);

}  // namespace geargraph
