#include "core/presentation/meshfile/mesh_reader.h"

#include <assimp/material.h>
#include <assimp/scene.h>

#include <assimp/Importer.hpp>
#include <cmath>
#include <unordered_map>
#include <utility>

namespace geargraph {
namespace {

MeshFileError unreadable(const std::string& why) {
  return {MeshFileError::Kind::file, "The 3D file could not be read: " + why};
}

float srgb(float channel) {
  return channel <= 0.0031308F ? channel * 12.92F : 1.055F * std::pow(channel, 1 / 2.4F) - 0.055F;
}

MeshMaterial materialOf(const aiMaterial& material, bool isLinear) {
  MeshMaterial result;
  result.name = material.GetName().C_Str();
  aiColor4D colour(0.7F, 0.7F, 0.7F, 1);
  material.Get(AI_MATKEY_COLOR_DIFFUSE, colour);
  result.colour = {colour.r, colour.g, colour.b};
  if (isLinear) {
    for (float& channel : result.colour) channel = srgb(channel);
  }
  return result;
}

/// assimp passes on what a broken PLY file says.
bool isSound(const aiMesh& mesh) {
  for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
    const aiFace& face = mesh.mFaces[i];
    for (unsigned k = 0; k < face.mNumIndices; ++k) {
      if (face.mIndices[k] >= mesh.mNumVertices) return false;
    }
  }
  return true;
}

Solid solidOf(const aiMesh& mesh) {
  Solid solid;
  for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
    const aiVector3D& p = mesh.mVertices[i];
    solid.positions.push_back({p.x, p.y, p.z});
    if (!mesh.HasNormals()) continue;
    const aiVector3D& n = mesh.mNormals[i];
    solid.normals.push_back({n.x, n.y, n.z});
  }
  for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
    const aiFace& face = mesh.mFaces[i];
    for (unsigned k = 2; k < face.mNumIndices; ++k) {  // a polygon is a fan
      solid.triangles.push_back({face.mIndices[0], face.mIndices[k - 1], face.mIndices[k]});
    }
  }
  return solid;
}

/// Walks assimp's tree without recursion, so that a deep one costs no stack.
class Reader {
 public:
  Reader(const aiScene& scene, const MeshReadLimits& limits) : m_scene(scene), m_limits(limits) {}

  std::variant<MeshScene, MeshFileError> read(bool isLinear) {
    for (unsigned i = 0; i < m_scene.mNumMaterials; ++i) {
      m_result.materials.push_back(materialOf(*m_scene.mMaterials[i], isLinear));
    }
    for (unsigned i = 0; i < m_scene.mNumMeshes; ++i) {
      if (!isSound(*m_scene.mMeshes[i])) return unreadable("a face names a vertex that is not there.");
      m_solids.push_back(std::make_shared<const Solid>(solidOf(*m_scene.mMeshes[i])));
    }
    m_result.name = m_scene.mRootNode->mName.C_Str();
    std::vector<std::pair<const aiNode*, std::size_t>> open{{m_scene.mRootNode, kNoNode}};
    while (!open.empty()) {
      const auto [node, parent] = open.back();
      open.pop_back();
      if (auto error = addNode(*node, parent)) return *error;
      const std::size_t place = m_places.at(node);
      for (unsigned i = node->mNumChildren; i-- > 0;) open.emplace_back(node->mChildren[i], place);
    }
    addKeys();
    return std::move(m_result);
  }

 private:
  std::optional<MeshFileError> addNode(const aiNode& source, std::size_t parent) {
    if (m_result.nodes.size() + source.mNumMeshes >= m_limits.mostNodes) {
      return MeshFileError{MeshFileError::Kind::limit, "The 3D file has more nodes than the limit of " +
                                                           std::to_string(m_limits.mostNodes) + "."};
    }
    MeshNode node;
    node.name = source.mName.C_Str();
    node.parent = parent;
    for (unsigned row = 0; row < 3; ++row) {
      for (unsigned column = 0; column < 4; ++column) {
        node.pose.matrix()(row, column) = static_cast<double>(source.mTransformation[row][column]);
      }
    }
    const double rigid =
        (node.pose.linear().transpose() * node.pose.linear() - Eigen::Matrix3d::Identity()).norm();
    if (!(rigid < 1e-4)) return unreadable("node \"" + node.name + "\" is scaled or skewed.");
    const std::size_t place = m_result.nodes.size();
    m_places[&source] = place;
    m_byName.emplace(node.name, place);
    if (source.mNumMeshes == 1) addSolid(node, source.mMeshes[0]);
    m_result.nodes.push_back(std::move(node));
    for (unsigned i = 0; source.mNumMeshes > 1 && i < source.mNumMeshes; ++i) {
      MeshNode& part = m_result.nodes.emplace_back();
      part.parent = place;
      part.name = m_scene.mMeshes[source.mMeshes[i]]->mName.C_Str();
      addSolid(part, source.mMeshes[i]);
    }
    return std::nullopt;
  }

  void addSolid(MeshNode& node, unsigned mesh) {
    node.solid = m_solids[mesh];
    node.material = m_scene.mMeshes[mesh]->mMaterialIndex;
  }

  void addKeys() {
    for (unsigned i = 0; i < m_scene.mNumAnimations; ++i) {
      const aiAnimation& animation = *m_scene.mAnimations[i];
      const double ticks =
          animation.mTicksPerSecond > 0 ? animation.mTicksPerSecond : 25;  // assimp's own default
      for (unsigned k = 0; k < animation.mNumChannels; ++k) {
        const aiNodeAnim& channel = *animation.mChannels[k];
        const auto found = m_byName.find(channel.mNodeName.C_Str());
        if (found == m_byName.end()) continue;
        for (unsigned j = 0; j < channel.mNumRotationKeys; ++j) {
          const aiQuatKey& key = channel.mRotationKeys[j];
          m_result.nodes[found->second].keys.push_back(
              {key.mTime / ticks,
               Eigen::Quaterniond(key.mValue.w, key.mValue.x, key.mValue.y, key.mValue.z)});
        }
      }
    }
  }

  const aiScene& m_scene;
  const MeshReadLimits& m_limits;
  MeshScene m_result;
  std::vector<std::shared_ptr<const Solid>> m_solids;
  std::unordered_map<const aiNode*, std::size_t> m_places;
  std::unordered_map<std::string, std::size_t> m_byName;
};

}  // namespace

std::variant<MeshScene, MeshFileError> readMesh(std::string_view bytes, MeshFormat format,
                                                const MeshReadLimits& limits) {
  if (bytes.size() > limits.mostBytes) {
    return MeshFileError{MeshFileError::Kind::limit, "The 3D file has " + std::to_string(bytes.size()) +
                                                         " bytes, more than the limit of " +
                                                         std::to_string(limits.mostBytes) + "."};
  }
  Assimp::Importer importer;
  const std::string hint(meshFormatName(format));
  const aiScene* scene = importer.ReadFileFromMemory(bytes.data(), bytes.size(), 0, hint.c_str());
  if (scene == nullptr || scene->mRootNode == nullptr) return unreadable(importer.GetErrorString());

  std::size_t triangles = 0;
  for (unsigned i = 0; i < scene->mNumMeshes; ++i) triangles += scene->mMeshes[i]->mNumFaces;
  if (triangles > limits.mostTriangles) {
    return MeshFileError{MeshFileError::Kind::limit, "The 3D file has " + std::to_string(triangles) +
                                                         " faces, more than the limit of " +
                                                         std::to_string(limits.mostTriangles) + "."};
  }
  return Reader(*scene, limits).read(format == MeshFormat::glb);
}

}  // namespace geargraph
