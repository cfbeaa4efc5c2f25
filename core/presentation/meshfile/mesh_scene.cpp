#include "core/presentation/meshfile/mesh_scene.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

#include "core/foundations/base/contract.h"

namespace geargraph {
namespace {

template <class LocalPose>
std::vector<Eigen::Isometry3d> chained(const MeshScene& scene, const LocalPose& localPose) {
  std::vector<Eigen::Isometry3d> world;
  world.reserve(scene.nodes.size());
  for (const MeshNode& node : scene.nodes) {
    const Eigen::Isometry3d local = localPose(node);
    GEARGRAPH_REQUIRE(node.parent == kNoNode || node.parent < world.size());
    world.push_back(node.parent == kNoNode ? local : world[node.parent] * local);
  }
  return world;
}

}  // namespace

double durationOf(const MeshScene& scene) {
  double duration = 0;
  for (const MeshNode& node : scene.nodes) {
    if (!node.keys.empty()) duration = std::max(duration, node.keys.back().seconds);
  }
  return duration;
}

Eigen::Isometry3d poseAt(const MeshNode& node, double seconds) {
  if (node.keys.empty()) return node.pose;
  const auto later = std::upper_bound(node.keys.begin(), node.keys.end(), seconds,
                                      [](double time, const RotationKey& key) { return time < key.seconds; });
  Eigen::Quaterniond rotation;
  if (later == node.keys.begin()) {
    rotation = later->rotation;
  } else if (later == node.keys.end()) {
    rotation = node.keys.back().rotation;
  } else {
    const RotationKey& before = *std::prev(later);
    const double part = (seconds - before.seconds) / (later->seconds - before.seconds);
    rotation = before.rotation.slerp(part, later->rotation);
  }
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = rotation.normalized().toRotationMatrix();
  pose.translation() = node.pose.translation();
  return pose;
}

std::vector<Eigen::Isometry3d> worldPoses(const MeshScene& scene) {
  return chained(scene, [](const MeshNode& node) { return node.pose; });
}

std::vector<Eigen::Isometry3d> worldPosesAt(const MeshScene& scene, double seconds) {
  return chained(scene, [seconds](const MeshNode& node) { return poseAt(node, seconds); });
}

std::size_t triangleCount(const MeshScene& scene) {
  std::size_t count = 0;
  for (const MeshNode& node : scene.nodes) count += node.solid ? node.solid->triangles.size() : 0;
  return count;
}

MeshScene flattened(const MeshScene& scene) {
  MeshScene flat{scene.name, scene.unit, scene.materials, {}};
  const std::vector<Eigen::Isometry3d> world = worldPoses(scene);
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    const MeshNode& node = scene.nodes[i];
    if (!node.solid || node.solid->empty()) continue;
    MeshNode& part = flat.nodes.emplace_back();
    part.name = node.name;
    part.material = node.material;
    part.solid = world[i].isApprox(Eigen::Isometry3d::Identity(), 0)
                     ? node.solid
                     : std::make_shared<const Solid>(moved(*node.solid, world[i]));
  }
  return flat;
}

MeshScene withRoot(const MeshScene& scene) {
  MeshScene rooted{scene.name, scene.unit, scene.materials, {}};
  rooted.nodes.reserve(scene.nodes.size() + 1);
  rooted.nodes.emplace_back().name = scene.name.empty() ? "mechanism" : scene.name;
  for (MeshNode node : scene.nodes) {
    node.parent = node.parent == kNoNode ? 0 : node.parent + 1;
    rooted.nodes.push_back(std::move(node));
  }
  return rooted;
}

MeshScene withDistinctNames(MeshScene scene) {
  std::set<std::string> taken;
  std::map<std::string, int> next;  // of equal names: where the search for a free number goes on
  for (MeshNode& node : scene.nodes) {
    const std::string wanted = node.name.empty() ? "node" : node.name;
    std::string name = wanted;
    for (int& i = next.try_emplace(wanted, 2).first->second; !taken.insert(name).second; ++i)
      name = wanted + " (" + std::to_string(i) + ")";
    node.name = std::move(name);
  }
  return scene;
}

double metresPerUnit(const std::string& unit) {
  static constexpr std::array<std::pair<std::string_view, double>, 8> kUnits{{{"um", 1e-6},
                                                                              {"µm", 1e-6},
                                                                              {"mm", 1e-3},
                                                                              {"cm", 1e-2},
                                                                              {"dm", 1e-1},
                                                                              {"m", 1},
                                                                              {"in", 0.0254},
                                                                              {"ft", 0.3048}}};
  for (const auto& [name, metres] : kUnits) {
    if (name == unit) return metres;
  }
  return 1e-3;
}

}  // namespace geargraph
