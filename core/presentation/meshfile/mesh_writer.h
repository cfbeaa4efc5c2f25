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

namespace geargraph::inline meshfile {

/// Why a 3D file was not written or read. Nothing is wrong with a document, so it is no Diagnostic.
struct MeshFileError {
  enum class Kind {
    stopped,  ///< somebody asked for it
    limit,    ///< larger than the stated limit, or numbers beyond those of 3D files
    file      ///< the file system refused, or the file is not what its name says
  };
  Kind kind = Kind::file;
  std::string message;  ///< a sentence for the user
};

/// Called with the part that is done, growing from 0 to 1, on the caller's thread.
using Progress = std::function<void(double)>;

constexpr std::size_t kMostTriangles = 10'000'000;

struct MeshWriteOptions {
  Progress progress;
  std::stop_token stop;
  std::size_t mostTriangles = kMostTriangles;
};

/// A file in memory. OBJ comes in two, the second with the materials.
struct EncodedFile {
  std::string name;
  std::string bytes;
};

/// The files of a scene, named `stem` with the format's ending; the first is the one that users open.
///
/// Units    STL, OBJ, PLY: the scene's, which the file's header names; 3MF: the scene's where 3MF has it,
/// else
///          millimetres; GLB: metres, as the format demands, with the scene's unit in asset.extras.
/// Frames   STL and PLY hold one mesh and OBJ one group a solid, at rest, in the world's frame. 3MF holds an
///          object a solid with its place; GLB the tree of nodes, with motion.
/// Vertices are the solid's, so that welding equal positions closes the mesh again.
/// Numbers  a scene with one that is not finite, or beyond a float, is rejected: no file can hold it.
/// The same scene gives the same bytes every time.
/// Stopping is looked at before each solid and each piece of 1 MiB. Cost: O(triangles).
[[nodiscard]] std::variant<std::vector<EncodedFile>, MeshFileError> encodedMesh(
    const MeshScene& scene, MeshFormat format, const std::string& stem, const MeshWriteOptions& options = {});

/// Writes a scene beside and then to `path`, whole or not at all; "-" is standard output (OBJ: without
/// materials). Gives nothing where all went well. Memory: the files' size; of GLB, nothing of it.
[[nodiscard]] std::optional<MeshFileError> writeMesh(const MeshScene& scene, MeshFormat format,
                                                     const std::filesystem::path& path,
                                                     const MeshWriteOptions& options = {});

}  // namespace geargraph::inline meshfile
