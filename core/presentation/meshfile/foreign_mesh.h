#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <stop_token>
#include <string_view>
#include <variant>

#include "core/presentation/meshfile/mesh_writer.h"

namespace geargraph::inline meshfile {

/// What a file from elsewhere may cost before it is given up.
struct ForeignLimits {
  std::size_t mostBytes = std::size_t{256} << 20U;
  std::size_t mostTriangles = 2'000'000;
  std::size_t mostMemory = std::size_t{2} << 30U;  ///< of the process that reads it, bytes
  double mostSeconds = 20;  ///< of the clock; the process gets as much of the processor
};

/// STL, OBJ, PLY or GLB by the ending of the name, whatever its case; nothing where it is another.
[[nodiscard]] std::optional<MeshFormat> foreignFormat(const std::filesystem::path& path);

/// The solid of a file that nobody vouches for, lengths as they stand in it, all its meshes as one. It is
/// read by the program `reader` (geargraph-mesh) in a process of its own with these limits, which gets the
/// open file and nothing else (core/sandbox): whatever the file does to it costs a sentence here, of one
/// line. Portable: that process is not confined, and its memory has no limit. Files that it names (the
/// materials of an OBJ, buffers of a GLB) are not read. Fails with `file` for what is no regular file or
/// cannot be read, `limit` beyond a limit, `stopped`. The solid need not be closed; its indices are in range
/// and its numbers finite.
[[nodiscard]] std::variant<Solid, MeshFileError> readForeignMesh(const std::filesystem::path& reader,
                                                                 const std::filesystem::path& path,
                                                                 const ForeignLimits& limits = {},
                                                                 const std::stop_token& stop = {});

/// Where the reader is: what the environment names as GEARGRAPH_MESH_READER, else beside the running program,
/// or where the build puts it. Empty where there is none.
[[nodiscard]] std::filesystem::path foreignMeshReader();

// The other side, for the reader's own process.

/// All meshes of the bytes as assimp reads them, triangles only; smooth across less than 35 degrees where the
/// file gives no normals of its own. Opens no other file. May crash on a hostile file.
[[nodiscard]] std::variant<Solid, MeshFileError> readForeignBytes(std::string_view bytes, MeshFormat format,
                                                                  std::size_t mostTriangles);
/// How the two sides speak: counts and arrays as they lie in memory.
[[nodiscard]] std::string packedSolid(const Solid& solid);
/// Nothing where the bytes are not what packedSolid() writes, within the limit.
[[nodiscard]] std::optional<Solid> unpackedSolid(std::string_view bytes, std::size_t mostTriangles);

}  // namespace geargraph::inline meshfile
