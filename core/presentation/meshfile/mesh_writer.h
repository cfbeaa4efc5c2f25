#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <variant>
#include <vector>

#include "core/presentation/meshfile/mesh_format.h"
#include "core/presentation/meshfile/mesh_scene.h"

namespace geargraph {

/// Why a 3D file was not written or read. It does not concern the document, so it is no Diagnostic.
struct MeshFileError {
  enum class Kind {
    stopped,  ///< a stop was requested
    limit,    ///< above a limit, or with numbers that 3D files cannot contain
    file      ///< an error of the file system, or the file is not of the format of its name
  };
  Kind kind = Kind::file;
  std::string message;  ///< a sentence for the user
};

/// Called with the fraction done, increasing from 0 to 1, on the caller's thread.
using Progress = std::function<void(double)>;

constexpr std::size_t kMaxTriangles = 10'000'000;

struct MeshWriteOptions {
  Progress progress;
  std::stop_token stop;
  std::size_t mostTriangles = kMaxTriangles;
};

/// A file in memory. OBJ has two, the second with the materials.
struct EncodedFile {
  std::string name;
  std::string bytes;
};

/// The files of a scene, named `stem` with the format's extension; the first is the one that users open.
///
/// Units    STL, OBJ, PLY: the scene's, which the file's header names; 3MF: the scene's where 3MF has it,
/// else millimetres; GLB: metres, as the format requires, with the scene's unit in asset.extras. Frames STL
/// and PLY have one mesh and OBJ one group per solid, at rest, in the world frame. 3MF has one object per
/// solid with its place; GLB the tree of nodes, with motion. Vertices are the solid's, so that welding equal
/// positions closes the mesh again. Numbers a scene with a number that is not finite or beyond a float is
/// rejected. The same scene gives the same bytes every time. `stop` is checked before each solid and each
/// piece of 1 MiB. Cost: O(triangles).
[[nodiscard]] std::variant<std::vector<EncodedFile>, MeshFileError> encodedMesh(
    const MeshScene& scene, MeshFormat format, const std::string& stem, const MeshWriteOptions& options = {});

/// Writes a scene to `path` atomically; "-" is standard output (OBJ: without materials). Returns std::nullopt
/// on success. Memory: the size of the files; for GLB constant.
[[nodiscard]] std::optional<MeshFileError> writeMesh(const MeshScene& scene, MeshFormat format,
                                                     const std::filesystem::path& path,
                                                     const MeshWriteOptions& options = {});

}  // namespace geargraph
