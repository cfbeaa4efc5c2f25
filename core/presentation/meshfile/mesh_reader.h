#pragma once

#include <string_view>

#include "core/presentation/meshfile/mesh_writer.h"

namespace geargraph {

struct MeshReadLimits {
  std::size_t mostBytes = std::size_t{512} << 20U;
  std::size_t mostTriangles = kMaxTriangles;
  std::size_t mostNodes = 100'000;
};

/// A scene from the bytes of a 3D file, as assimp reads it: lengths as in the file, vertices as in the
/// format, a node with several meshes as a node with a child for each. Rotation keys are in seconds; keys of
/// position and scale are not read, and frames that are not rigid are rejected. An untrusted file may crash
/// assimp: use readForeignMesh() for such files.
[[nodiscard]] std::variant<MeshScene, MeshFileError> readMesh(std::string_view bytes, MeshFormat format,
                                                              const MeshReadLimits& limits = {});

}  // namespace geargraph
