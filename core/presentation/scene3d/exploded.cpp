#include "core/presentation/scene3d/exploded.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "core/foundations/base/contract.h"

namespace geargraph {
namespace {

constexpr double kSameDirection = 1e-6;
constexpr double kGap = 0.12;    // of the scene's radius, between neighbours
constexpr double kGrain = 0.02;  // of the scene's radius: nearer middles are in one plane

/// The links that turn about axes of one direction.
struct Row {
  Eigen::Vector3d direction;
  std::map<ElementId, std::vector<std::size_t>> links;  ///< their instances
};

/// A link, or several equal ones, as far as it reaches along the direction.
struct LinkExtent {
  std::vector<std::size_t> instances;
  double low = 1e300;
  double high = -1e300;
  double middle = 0;      ///< of the part with the largest radius, in grains
  double radius = 0;      ///< of that part, across the direction
  std::size_t solid = 0;  ///< that part's: equal planets have equal ones
};

// +d and -d are one direction: the first component that is not 0 is positive.
Eigen::Vector3d canonical(Eigen::Vector3d direction) {
  for (const double component : direction) {
    if (std::abs(component) < kSameDirection) continue;
    return component < 0 ? Eigen::Vector3d(-direction) : direction;
  }
  return direction;
}

std::vector<Row> rowsOf(const MechanismScene& stage, const std::stop_token& stop) {
  std::vector<Row> rows;
  for (std::size_t i = 0; i < stage.handles.size() && !stop.stop_requested(); ++i) {
    if (stage.handles[i].gains.empty()) continue;
    const Eigen::Vector3d direction = canonical(stage.handles[i].direction);
    auto row = std::find_if(rows.begin(), rows.end(), [&](const Row& known) {
      return (known.direction - direction).norm() < kSameDirection;
    });
    if (row == rows.end()) row = rows.insert(rows.end(), Row{direction, {}});
    row->links[stage.scene.instances[i].element].push_back(i);
  }
  return rows;
}

LinkExtent linkExtentOf(const Scene& scene, const std::vector<std::size_t>& instances,
                        const Eigen::Vector3d& direction, double grain) {
  LinkExtent extent;
  extent.instances = instances;
  for (const std::size_t i : instances) {
    const Instance& instance = scene.instances[i];
    const Eigen::AlignedBox3d box = scene.boxOf(instance.solid);
    if (box.isEmpty()) continue;
    const Eigen::Vector3d along = instance.pose.linear().transpose() * direction;
    const double half = 0.5 * along.cwiseAbs().dot(box.sizes());
    const double middle = direction.dot(instance.pose * box.center());
    extent.low = std::min(extent.low, middle - half);
    extent.high = std::max(extent.high, middle + half);
    const double radius = 0.5 * (box.sizes() - along.cwiseAbs().dot(box.sizes()) * along.cwiseAbs()).norm();
    if (radius <= extent.radius) continue;
    extent.radius = radius;
    extent.middle = std::round(middle / grain);
    extent.solid = instance.solid;
  }
  return extent;
}

/// Cars in the order of the row, equal ones in one plane coupled to one.
std::vector<LinkExtent> extentsInRow(const Scene& scene, const Row& row, double grain,
                                     const std::stop_token& stop) {
  std::vector<LinkExtent> extents;
  for (const auto& [link, instances] : row.links) {
    if (stop.stop_requested()) break;
    LinkExtent extent = linkExtentOf(scene, instances, row.direction, grain);
    const auto identical = std::find_if(extents.begin(), extents.end(), [&](const LinkExtent& known) {
      return known.solid == extent.solid && known.middle == extent.middle;
    });
    if (identical == extents.end()) {
      extents.push_back(std::move(extent));
      continue;
    }
    identical->instances.insert(identical->instances.end(), extent.instances.begin(), extent.instances.end());
    identical->low = std::min(identical->low, extent.low);
    identical->high = std::max(identical->high, extent.high);
  }
  std::stable_sort(extents.begin(), extents.end(), [](const LinkExtent& a, const LinkExtent& b) {
    return std::tuple(a.middle, a.radius) < std::tuple(b.middle, b.radius);
  });
  return extents;
}

}  // namespace

std::vector<Eigen::Vector3d> explosionOffsets(const MechanismScene& stage, const std::stop_token& stop) {
  std::vector<Eigen::Vector3d> result(stage.scene.instances.size(), Eigen::Vector3d::Zero());
  const double size = boundsOf(stage.scene).radius();
  for (const Row& row : rowsOf(stage, stop)) {
    const std::vector<LinkExtent> extents = extentsInRow(stage.scene, row, kGrain * size, stop);
    double end = -1e300, sum = 0;
    std::vector<double> moves;
    for (const LinkExtent& extent : extents) {
      const double move = std::max(0.0, end + kGap * size - extent.low);
      moves.push_back(end > -1e299 ? move : 0);
      end = extent.high + moves.back();
      sum += moves.back();
    }
    for (std::size_t k = 0; k < extents.size(); ++k) {
      const double move = moves[k] - sum / static_cast<double>(extents.size());
      for (const std::size_t i : extents[k].instances) result[i] = move * row.direction;
    }
  }
  return result;
}

void explode(const Scene& scene, std::span<const Eigen::Vector3d> offsets, double part,
             std::span<Pose> poses) {
  if (part == 0) return;
  GEARGRAPH_REQUIRE(poses.size() == scene.instances.size() && poses.size() == offsets.size());
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Eigen::Matrix3d turned = poses[i].linear() * scene.instances[i].pose.linear().transpose();
    poses[i].pretranslate(part * (turned * offsets[i]));
  }
}

}  // namespace geargraph
