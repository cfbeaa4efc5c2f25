// What runs in the process of geargraph-mesh, and the bytes between it and whoever asked.

#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/IOSystem.hpp>
#include <assimp/Importer.hpp>
#include <cmath>
#include <cstring>

#include "core/foundations/base/translation.h"
#include "core/presentation/meshfile/foreign_mesh.h"

namespace geargraph {
namespace {

constexpr float kCrease = 35;  // degrees
constexpr std::string_view kMagic = "GGM1";
constexpr std::size_t kHead = 4 + 2 * sizeof(std::uint32_t);

/// What is not in the bytes themselves is not there: the materials of an OBJ, buffers and pictures of a GLB.
class NoFiles final : public Assimp::IOSystem {
 public:
  bool Exists(const char*) const override { return false; }
  char getOsSeparator() const override { return '/'; }
  Assimp::IOStream* Open(const char*, const char*) override { return nullptr; }
  void Close(Assimp::IOStream*) override {}
  /// assimp's own is the one symbol here whose name depends on the C++ library that it was built with.
  const std::string& CurrentDirectory() const override {
    static const std::string kNone;
    return kNone;
  }
};

/// assimp searches the header of a PLY for its end without looking where the bytes end.
bool hasPlyHeader(std::string_view bytes) {
  return bytes.find("end_header\n") != std::string_view::npos ||
         bytes.find("end_header\r") != std::string_view::npos;
}

MeshFileError fileError(std::string_view text) {
  return {MeshFileError::Kind::file, readerReport(text, {})};
}

/// `why`: assimp's words.
MeshFileError damaged(std::string_view why) {
  return {MeshFileError::Kind::file, readerReport(toTranslate("It is damaged: %1"), {why})};
}

MeshFileError tooMany(std::size_t triangles, std::size_t most) {
  return {MeshFileError::Kind::limit,
          readerReport(toTranslate("The 3D file has %1 faces, more than the limit of %2."),
                       {std::to_string(triangles), std::to_string(most)})};
}

/// assimp passes on what a broken file says, and its further steps trust it.
bool hasSoundFaces(const aiMesh& mesh) {
  return std::all_of(mesh.mFaces, mesh.mFaces + mesh.mNumFaces, [&](const aiFace& face) {  // NOLINT: assimp's
    return std::all_of(face.mIndices, face.mIndices + face.mNumIndices,                    // arrays
                       [&](unsigned index) { return index < mesh.mNumVertices; });
  });
}

void appendMesh(Solid& solid, const aiMesh& mesh) {
  const auto first = static_cast<std::uint32_t>(solid.positions.size());
  for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
    const aiVector3D& p = mesh.mVertices[i];
    const aiVector3D n = mesh.HasNormals() ? mesh.mNormals[i] : aiVector3D(0, 0, 1);
    solid.positions.push_back({p.x, p.y, p.z});
    solid.normals.push_back({n.x, n.y, n.z});
  }
  for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
    const aiFace& face = mesh.mFaces[i];
    if (face.mNumIndices != 3) continue;  // points and lines that came along
    solid.triangles.push_back({first + face.mIndices[0], first + face.mIndices[1], first + face.mIndices[2]});
  }
}

template <class Item>
void appendArray(std::string& bytes, const std::vector<Item>& items) {
  bytes.append(reinterpret_cast<const char*>(items.data()), items.size() * sizeof(Item));  // NOLINT
}

template <class Item>
void takeArray(std::string_view& bytes, std::vector<Item>& items, std::size_t count) {
  items.resize(count);
  std::memcpy(items.data(), bytes.data(), count * sizeof(Item));
  bytes.remove_prefix(count * sizeof(Item));
}

bool isSound(const Solid& solid) {
  const auto finite = [](const Float3& v) {
    return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
  };
  const std::size_t count = solid.positions.size();
  return std::all_of(solid.positions.begin(), solid.positions.end(), finite) &&
         std::all_of(solid.normals.begin(), solid.normals.end(), finite) &&
         std::all_of(solid.triangles.begin(), solid.triangles.end(),
                     [count](const Triangle& t) { return t[0] < count && t[1] < count && t[2] < count; });
}

}  // namespace

std::variant<Solid, MeshFileError> readForeignBytes(std::string_view bytes, MeshFormat format,
                                                    std::size_t mostTriangles) {
  if (format == MeshFormat::ply && !hasPlyHeader(bytes))
    return fileError(toTranslate("It is damaged: its header has no end."));
  Assimp::Importer importer;
  importer.SetIOHandler(new NoFiles);  // NOLINT: the importer's
  importer.SetPropertyFloat(AI_CONFIG_PP_GSN_MAX_SMOOTHING_ANGLE, kCrease);
  // The normals of STL are those of its facets: round forms would be flat.
  const unsigned anew = format == MeshFormat::stl ? aiProcess_DropNormals : 0U;
  const unsigned steps = aiProcess_Triangulate | aiProcess_PreTransformVertices | aiProcess_GenSmoothNormals |
                         aiProcess_JoinIdenticalVertices | anew;
  const std::string hint(meshFormatName(format));
  const aiScene* scene = importer.ReadFileFromMemory(bytes.data(), bytes.size(), 0, hint.c_str());
  if (scene == nullptr) return damaged(importer.GetErrorString());
  std::size_t triangles = 0;
  for (unsigned i = 0; i < scene->mNumMeshes; ++i) triangles += scene->mMeshes[i]->mNumFaces;
  if (triangles > mostTriangles) return tooMany(triangles, mostTriangles);
  for (unsigned i = 0; i < scene->mNumMeshes; ++i) {
    if (!hasSoundFaces(*scene->mMeshes[i]))
      return fileError(toTranslate("It is damaged: a face names a vertex that is not there."));
  }
  scene = importer.ApplyPostProcessing(steps);
  if (scene == nullptr) return damaged(importer.GetErrorString());
  Solid solid;
  for (unsigned i = 0; i < scene->mNumMeshes; ++i) appendMesh(solid, *scene->mMeshes[i]);
  if (solid.triangles.size() > mostTriangles) return tooMany(solid.triangles.size(), mostTriangles);
  if (solid.empty() || !isSound(solid)) return fileError(toTranslate("It has no faces that could be shown."));
  return solid;
}

std::string readerReport(std::string_view text, std::initializer_list<std::string_view> places) {
  std::string report(text);
  for (const std::string_view place : places) (report += kReportSeparator) += place;
  return report;
}

std::string packedSolid(const Solid& solid) {
  std::string bytes(kMagic);
  for (const std::size_t count : {solid.positions.size(), solid.triangles.size()}) {
    const auto number = static_cast<std::uint32_t>(count);
    bytes.append(reinterpret_cast<const char*>(&number), sizeof number);  // NOLINT
  }
  appendArray(bytes, solid.positions);
  appendArray(bytes, solid.normals);
  appendArray(bytes, solid.triangles);
  return bytes;
}

std::optional<Solid> unpackedSolid(std::string_view bytes, std::size_t mostTriangles) {
  if (bytes.size() < kHead || bytes.substr(0, kMagic.size()) != kMagic) return std::nullopt;
  std::uint32_t vertices = 0, triangles = 0;
  std::memcpy(&vertices, bytes.data() + kMagic.size(), sizeof vertices);
  std::memcpy(&triangles, bytes.data() + kMagic.size() + sizeof vertices, sizeof triangles);
  bytes.remove_prefix(kHead);
  if (vertices == 0 || triangles == 0 || triangles > mostTriangles) return std::nullopt;
  if (bytes.size() != std::size_t{vertices} * 2 * sizeof(Float3) + std::size_t{triangles} * sizeof(Triangle))
    return std::nullopt;
  Solid solid;
  takeArray(bytes, solid.positions, vertices);
  takeArray(bytes, solid.normals, vertices);
  takeArray(bytes, solid.triangles, triangles);
  return isSound(solid) ? std::optional(std::move(solid)) : std::nullopt;
}

}  // namespace geargraph
