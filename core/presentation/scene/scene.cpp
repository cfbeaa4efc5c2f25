#include "core/presentation/scene/scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace geargraph {

const std::shared_ptr<const Solid>& DetailLevels::within(double most,
                                                         const std::shared_ptr<const Solid>& own) const {
  if (error <= most || finer.empty()) return own;
  const auto fits = [most](const LodLevel& level) { return level.error <= most; };
  const auto found = std::find_if(finer.begin(), finer.end(), fits);
  return (found != finer.end() ? *found : finer.back()).solid->solid();
}

const std::shared_ptr<const Solid>& DetailLevels::chosen(const std::shared_ptr<const Solid>& own,
                                                         double pixels) const {
  constexpr double kInvisible = 1.0 / 3;  // of a pixel
  return within(kInvisible / pixels, own);
}

std::vector<Eigen::Vector3d> cornersOf(const Scene& scene) {
  std::vector<Eigen::AlignedBox3d> boxes;
  boxes.reserve(scene.solids.size());
  for (std::size_t solid = 0; solid < scene.solids.size(); ++solid) boxes.push_back(scene.boxOf(solid));
  std::vector<Eigen::Vector3d> corners;
  for (const Instance& instance : scene.instances) {
    const Eigen::AlignedBox3d& box = boxes[instance.solid];
    if (box.isEmpty()) continue;
    for (int corner = 0; corner < 8; ++corner) {
      corners.push_back(instance.pose * box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner)));
    }
  }
  return corners;
}

namespace {

constexpr int kRound = 16;
constexpr std::array kRises{-1.0, -0.7, -0.3, 0.0, 0.3, 0.7, 1.0};
constexpr int kDirections = 2 + kRound * (static_cast<int>(kRises.size()) - 2);
using PerDirection = Eigen::Array<float, kDirections, 1>;

/// Directions all round, by component: the reach of a vertex in all of them is a few vector instructions.
struct Directions {
  PerDirection x, y, z;

  Directions() {
    int count = 0;
    for (const double rise : kRises) {
      const double level = std::sqrt(1 - rise * rise);
      for (int k = 0; k < (level == 0 ? 1 : kRound); ++k, ++count) {
        const double angle = 2 * std::numbers::pi * k / kRound;
        x[count] = static_cast<float>(level * std::cos(angle));
        y[count] = static_cast<float>(level * std::sin(angle));
        z[count] = static_cast<float>(rise);
      }
    }
  }
};

}  // namespace

std::size_t outlineSamples(const Scene& scene) {
  // Among hundreds of solids each is a small part of the picture.
  constexpr std::size_t kMaxSamples = std::size_t{1} << 18U;
  return std::clamp(kMaxSamples / std::max(scene.solids.size(), std::size_t{1}), std::size_t{64},
                    std::size_t{4096});
}

std::vector<Eigen::Vector3d> outlineOf(const Solid& solid, std::size_t samples) {
  if (solid.positions.empty()) return {};
  static const Directions directions;
  PerDirection reach = PerDirection::Constant(-std::numeric_limits<float>::infinity());
  std::vector<std::size_t> farthest(kDirections, 0);
  // A solid has thousands of vertices, of which neighbours reach equally far: some will do.
  const std::size_t step = 1 + solid.positions.size() / samples;
  for (std::size_t i = 0; i < solid.positions.size(); i += step) {
    const Float3& p = solid.positions[i];
    const PerDirection value = directions.x * p[0] + directions.y * p[1] + directions.z * p[2];
    if ((value - reach).maxCoeff() <= 0) continue;
    for (int d = 0; d < kDirections; ++d) {
      if (value[d] <= reach[d]) continue;
      reach[d] = value[d];
      farthest[static_cast<std::size_t>(d)] = i;
    }
  }
  std::sort(farthest.begin(), farthest.end());
  farthest.erase(std::unique(farthest.begin(), farthest.end()), farthest.end());
  std::vector<Eigen::Vector3d> points;
  for (const std::size_t i : farthest) {
    const Float3& p = solid.positions[i];
    points.emplace_back(p[0], p[1], p[2]);
  }
  return points;
}

std::shared_ptr<const SolidOutlines> solidOutlines(const Scene& scene, const std::stop_token& stop) {
  if (scene.outlines != nullptr && scene.outlines->size() == scene.solids.size()) return scene.outlines;
  const std::size_t samples = outlineSamples(scene);
  auto outlines = std::make_shared<SolidOutlines>(scene.solids.size());
  for (std::size_t i = 0; i < outlines->size() && !stop.stop_requested(); ++i)
    (*outlines)[i] = outlineOf(*scene.solids[i], samples);
  return outlines;
}

std::vector<Eigen::Vector3d> outlineOf(const Scene& scene) {
  const auto outlines = solidOutlines(scene);
  std::vector<Eigen::Vector3d> points;
  for (const Instance& instance : scene.instances) {
    for (const Eigen::Vector3d& point : (*outlines)[instance.solid]) points.push_back(instance.pose * point);
  }
  return points;
}

Bounds boundsOf(const Scene& scene) {
  Bounds bounds;
  for (const Eigen::Vector3d& corner : cornersOf(scene)) bounds.box.extend(corner);
  return bounds;
}

}  // namespace geargraph
