#include "tests/core/presentation/meshfile/cogs.h"

#include <cmath>
#include <numbers>

namespace geargraph::test {
namespace {

constexpr double kPi = std::numbers::pi;

Float3 narrow(const Eigen::Vector3d& p) {
  return {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())};
}

/// A flat polygon as a fan from its first corner, all with one normal.
void addFace(Solid& solid, const std::vector<Eigen::Vector3d>& corners) {
  const Eigen::Vector3d normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
  const auto first = static_cast<std::uint32_t>(solid.positions.size());
  for (const Eigen::Vector3d& corner : corners) {
    solid.positions.push_back(narrow(corner));
    solid.normals.push_back(narrow(normal));
  }
  for (std::uint32_t k = 2; k < corners.size(); ++k)
    solid.triangles.push_back({first, first + k - 1, first + k});
}

std::vector<Eigen::Vector3d> outline(int teeth, double radius, double height) {
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 4 * teeth; ++i) {
    const double angle = (i - 0.5) * 2 * kPi / (4 * teeth);
    const double r = i % 4 < 2 ? radius : 0.8 * radius;
    points.emplace_back(r * std::cos(angle), r * std::sin(angle), height);
  }
  return points;
}

std::vector<RotationKey> turns(const Eigen::Vector3d& axis, double count, double seconds) {
  std::vector<RotationKey> keys;
  const int steps = static_cast<int>(std::ceil(std::abs(count) * 4));
  for (int i = 0; i <= steps; ++i) {
    const double half = kPi * count * i / steps;
    const Eigen::Vector3d v = std::sin(half) * axis;
    keys.push_back({seconds * i / steps, Eigen::Quaterniond(std::cos(half), v.x(), v.y(), v.z())});
  }
  return keys;
}

}  // namespace

Solid cog(int teeth, double radius, double width) {
  const auto bottom = outline(teeth, radius, -width / 2);
  const auto top = outline(teeth, radius, width / 2);
  Solid solid;
  const Eigen::Vector3d low(0, 0, -width / 2);
  const Eigen::Vector3d high(0, 0, width / 2);
  for (std::size_t i = 0; i < top.size(); ++i) {
    const std::size_t j = (i + 1) % top.size();
    addFace(solid, {bottom[i], bottom[j], top[j], top[i]});
    addFace(solid, {high, top[i], top[j]});
    addFace(solid, {low, bottom[j], bottom[i]});
  }
  return solid;
}

MeshScene movingScene() {
  MeshScene scene;
  scene.name = "Planet & Träger";
  scene.materials = {{"link 0", {0.25F, 0.5F, 0.75F}}, {"link 1 \"blue\"", {0.1F, 0.2F, 1}}};
  const auto small = std::make_shared<const Solid>(cog(12, 6, 5));
  const auto large = std::make_shared<const Solid>(cog(30, 15, 5));
  const Eigen::Isometry3d aside(Eigen::Translation3d(3, 7, -2));

  scene.nodes.push_back({"ground", kNoNode, Eigen::Isometry3d::Identity(), nullptr, 0, {}});
  scene.nodes.push_back({"wheel", 0, Eigen::Isometry3d(Eigen::Translation3d(40, 0, 0)), small, 0, {}});
  scene.nodes.push_back({"wheel", 0, Eigen::Isometry3d(Eigen::Translation3d(60, 0, 0)), small, 0, {}});
  scene.nodes.push_back({"carrier <1>", kNoNode, aside, large, 1, turns(Eigen::Vector3d::UnitZ(), 1, 4)});
  Eigen::Isometry3d onCarrier(Eigen::Translation3d(21, 0, 0));
  onCarrier.rotate(Eigen::AngleAxisd(kPi / 2, Eigen::Vector3d::UnitX()));
  const Eigen::Quaterniond rest(onCarrier.linear());
  std::vector<RotationKey> spin = turns(Eigen::Vector3d::UnitZ(), -3, 4);
  for (RotationKey& key : spin) key.rotation = rest * key.rotation;
  scene.nodes.push_back({"planet", 3, onCarrier, small, 1, spin});
  return scene;
}

}  // namespace geargraph::test
