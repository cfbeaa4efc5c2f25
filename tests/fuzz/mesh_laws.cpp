#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "core/foundations/files/file.h"
#include "core/presentation/meshfile/foreign_mesh.h"
#include "tests/fuzz/laws.h"

namespace geargraph::test {
namespace {

constexpr std::array kFormats = {MeshFormat::stl, MeshFormat::obj, MeshFormat::ply, MeshFormat::glb};
constexpr std::size_t kMaxTriangles = 100'000;

MeshFormat formatOf(const std::string& input) {
  return kFormats[static_cast<unsigned char>(input.front()) % kFormats.size()];
}

void checkSolid(const Solid& solid, const std::string& input) {
  if (solid.triangles.empty() || solid.triangles.size() > kMaxTriangles)
    lawFailed("A solid of too few or too many faces", input);
  if (solid.normals.size() != solid.positions.size()) lawFailed("A vertex without a normal", input);
  for (const Triangle& triangle : solid.triangles) {
    for (const auto vertex : triangle) {
      if (vertex >= solid.positions.size()) lawFailed("A face names a vertex that is not there", input);
    }
  }
  for (const auto* vectors : {&solid.positions, &solid.normals}) {
    for (const Float3& vector : *vectors) {
      for (const float coordinate : vector) {
        if (!std::isfinite(coordinate)) lawFailed("A coordinate is not finite", input);
      }
    }
  }
}

}  // namespace

void checkMeshHere(const std::string& input) {
  if (input.empty()) return;
  const auto read = readForeignBytes(std::string_view(input).substr(1), formatOf(input), kMaxTriangles);
  if (const auto* solid = std::get_if<Solid>(&read)) checkSolid(*solid, input);
  if (const auto* error = std::get_if<MeshFileError>(&read); error != nullptr && error->message.empty())
    lawFailed("An error says nothing", input);
}

void checkMeshConfined(const std::string& input) {
  if (input.empty()) return;
  const std::filesystem::path path =
      std::filesystem::temp_directory_path() /
      ("geargraph-fuzz-" + std::to_string(::getpid()) + "." + std::string(meshFormatName(formatOf(input))));
  if (writeFile(path, std::string_view(input).substr(1)))
    lawFailed("The temporary file was not written", input);
  ForeignLimits limits;
  limits.mostTriangles = kMaxTriangles;
  limits.mostSeconds = 5;
  const auto read = readForeignMesh(foreignMeshReader(), path, limits);
  std::filesystem::remove(path);
  if (const auto* solid = std::get_if<Solid>(&read)) return checkSolid(*solid, input);
  const std::string& message = std::get<MeshFileError>(read).message;
  if (message.empty() || message.size() > 1300 || message.find('\n') != std::string::npos)
    lawFailed("An error is no sentence of one line", input);
  if (message.find("missing") != std::string::npos || message.find("cannot") != std::string::npos)
    lawFailed(message.c_str(), input);  // geargraph-mesh itself did not run
}

void checkMeshAnswer(const std::string& bytes) {
  const auto solid = unpackedSolid(bytes, kMaxTriangles);
  if (!solid) return;
  checkSolid(*solid, bytes);
  if (packedSolid(*solid) != bytes) lawFailed("What was unpacked packs into other bytes", bytes);
}

}  // namespace geargraph::test
