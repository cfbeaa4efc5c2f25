#include "core/presentation/painting/scene.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace geargraph::inline painting {

const std::shared_ptr<const Solid>& DetailLevels::within(double most,
                                                         const std::shared_ptr<const Solid>& own) const {
  if (error <= most || finer.empty()) return own;
  const auto fits = [most](const Finer& level) { return level.error <= most; };
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

/// The vertices of a solid that reach farthest in directions all round, of about `samples` of them.
std::vector<Eigen::Vector3d> farthestOf(const Solid& solid, std::size_t samples) {
  constexpr int kRound = 16;
  std::vector<Eigen::Vector3f> directions;
  for (const double rise : {-1.0, -0.7, -0.3, 0.0, 0.3, 0.7, 1.0}) {
    for (int k = 0; k < kRound; ++k) {
      const double angle = 2 * std::numbers::pi * k / kRound, level = std::sqrt(1 - rise * rise);
      directions.emplace_back(
          Eigen::Vector3d(level * std::cos(angle), level * std::sin(angle), rise).cast<float>());
      if (level == 0) break;
    }
  }
  std::vector<float> reach(directions.size(), -std::numeric_limits<float>::infinity());
  std::vector<std::size_t> farthest(directions.size(), 0);
  // A solid has thousands of vertices, of which neighbours reach equally far: some will do.
  const std::size_t step = 1 + solid.positions.size() / samples;
  for (std::size_t i = 0; i < solid.positions.size(); i += step) {
    const Float3& p = solid.positions[i];
    for (std::size_t d = 0; d < directions.size(); ++d) {
      const float value = directions[d].x() * p[0] + directions[d].y() * p[1] + directions[d].z() * p[2];
      if (value <= reach[d]) continue;
      reach[d] = value;
      farthest[d] = i;
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

}  // namespace

std::vector<Eigen::Vector3d> outlineOf(const Scene& scene) {
  // Among hundreds of solids each is a small part of the picture, and the window waits for the answer.
  constexpr std::size_t kMostSamples = std::size_t{1} << 18U;
  const std::size_t samples = std::clamp(kMostSamples / std::max(scene.solids.size(), std::size_t{1}),
                                         std::size_t{64}, std::size_t{4096});
  std::vector<std::optional<std::vector<Eigen::Vector3d>>> farthest(scene.solids.size());
  std::vector<Eigen::Vector3d> points;
  for (const Instance& instance : scene.instances) {
    auto& own = farthest[instance.solid];
    const Solid& solid = *scene.solids[instance.solid];
    if (!own) own = solid.positions.empty() ? std::vector<Eigen::Vector3d>() : farthestOf(solid, samples);
    for (const Eigen::Vector3d& point : *own) points.push_back(instance.pose * point);
  }
  return points;
}

Bounds boundsOf(const Scene& scene) {
  Bounds bounds;
  for (const Eigen::Vector3d& corner : cornersOf(scene)) bounds.box.extend(corner);
  return bounds;
}

}  // namespace geargraph::inline painting
