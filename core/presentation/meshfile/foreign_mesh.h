#pragma once

#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <variant>

#include "core/presentation/meshfile/mesh_writer.h"

namespace geargraph {

/// The limits for reading an untrusted 3D file.
struct ForeignLimits {
  std::size_t mostBytes = std::size_t{256} << 20U;
  std::size_t mostTriangles = 2'000'000;
  std::size_t mostMemory = std::size_t{2} << 30U;  ///< of the process that reads it, bytes
  double mostSeconds = 20;                         ///< wall-clock time; also the limit of CPU time
};

/// STL, OBJ, PLY or GLB by the file name's extension, case-insensitive; std::nullopt for any other.
[[nodiscard]] std::optional<MeshFormat> foreignFormat(const std::filesystem::path& path);

/// The solid of an untrusted file: all its meshes as one, lengths as in the file. The file is read by the
/// program `reader` (geargraph-mesh) in a sandboxed process with these limits, which gets the open file and
/// nothing else (core/foundations/sandbox); if that process crashes, this returns an error. Portable version:
/// that process is not sandboxed, and its memory is not limited. Files that it refers to (the materials of an
/// OBJ, buffers of a GLB) are not read. Fails with `file` for anything but a readable regular file, `limit`
/// beyond a limit, `stopped`. The solid need not be closed; its indices are in range and its numbers finite.
[[nodiscard]] std::variant<Solid, MeshFileError> readForeignMesh(const std::filesystem::path& reader,
                                                                 const std::filesystem::path& path,
                                                                 const ForeignLimits& limits = {},
                                                                 const std::stop_token& stop = {});

/// The path of the reader: the environment variable GEARGRAPH_MESH_READER, else beside the running program,
/// or where the build puts it. Empty if there is none.
[[nodiscard]] std::filesystem::path foreignMeshReader();

// For the reader's process, which has no catalogue: its parent translates what it reports.

constexpr char kReportSeparator = '\x1f';  ///< between the parts of a report
/// A text that toTranslate() marks with what goes into its placeholders %1 and %2, as the parent reads it.
[[nodiscard]] std::string readerReport(std::string_view text, std::initializer_list<std::string_view> places);

/// All meshes of the bytes as assimp reads them, triangles only; without normals in the file, edges below 35
/// degrees are smoothed. Opens no other file. May crash on a malicious file. The message of an error is a
/// readerReport().
[[nodiscard]] std::variant<Solid, MeshFileError> readForeignBytes(std::string_view bytes, MeshFormat format,
                                                                  std::size_t mostTriangles);
/// The format between the two processes: counts and arrays as in memory.
[[nodiscard]] std::string packedSolid(const Solid& solid);
/// std::nullopt if the bytes are not what packedSolid() writes, within the limit.
[[nodiscard]] std::optional<Solid> unpackedSolid(std::string_view bytes, std::size_t mostTriangles);

}  // namespace geargraph
