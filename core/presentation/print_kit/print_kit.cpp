#include "core/presentation/print_kit/print_kit.h"

#include <algorithm>
#include <cmath>

#include "core/foundations/base/translation.h"
#include "core/presentation/print_kit/kit_builder.h"
#include "core/presentation/print_kit/kit_check.h"
#include "core/presentation/print_kit/kit_plates.h"

namespace geargraph {
namespace {

using Eigen::Vector3d;

/// The direction from the base to the rest: along the axes of the ground, from most of their bearings to most
/// of the wheels.
std::optional<Vector3d> upOf(const Arrangement& plan, const GearTrain& train) {
  const AxisLayout* first = nullptr;
  double bearings = 0, count = 0;
  for (const AxisLayout& axis : plan.axes) {
    for (const Bearing& bearing : axis.bearings) {
      if (bearing.parent != 0) continue;
      if (first == nullptr) first = &axis;
      bearings += axis.at(bearing.at).dot(first->direction);
      ++count;
    }
  }
  if (first == nullptr || train.gears.empty()) return std::nullopt;
  double wheels = 0;
  for (const TrainGear& gear : train.gears) wheels += gear.pose.translation().dot(first->direction);
  wheels /= static_cast<double>(train.gears.size());
  return bearings / count > wheels + 1e-9 ? Vector3d(-first->direction) : first->direction;
}

KitFailure overlapFailure(const KitBuilder& kit, std::size_t a, std::size_t b) {
  return {KitFailure::Kind::overlap,
          translated("Printed, \"%1\" and \"%2\" would overlap.", {kit.parts[a].name, kit.parts[b].name}),
          {}};
}

/// Equal names get numbers.
void numberNames(std::vector<KitPart>& parts) {
  for (std::size_t p = 0; p < parts.size(); ++p) {
    std::vector<std::size_t> same;
    for (std::size_t q = p; q < parts.size(); ++q) {
      if (parts[q].name == parts[p].name) same.push_back(q);
    }
    if (same.size() < 2) continue;
    for (std::size_t i = 0; i < same.size(); ++i) parts[same[i]].name += '-' + std::to_string(i + 1);
  }
}

/// The ways that parts may come along: the axes of the train, both ways.
std::vector<Vector3d> waysOf(const KitBuilder& kit) {
  std::vector<Vector3d> ways{kit.up, -kit.up};
  for (const AxisLayout& axis : kit.plan.axes) {
    for (const Vector3d& way : {Vector3d(axis.direction), Vector3d(-axis.direction)}) {
      const bool isNew = std::none_of(ways.begin(), ways.end(),
                                      [&](const Vector3d& known) { return (known - way).norm() < 1e-6; });
      if (isNew) ways.push_back(way);
    }
  }
  return ways;
}

}  // namespace

std::variant<PrintKit, KitFailure> printKit(const Mechanism& mechanism, const Placement& placement,
                                            const GearTrain& train, const Arrangement& arrangement,
                                            double unit, std::span<const KitPose> poses,
                                            const KitOptions& options, const std::stop_token& stop) {
  const KitFailure stopped{KitFailure::Kind::stopped, {}, {}};
  KitBuilder kit(mechanism, placement, train, arrangement, unit * options.scale, options);
  kit.stop = stop;
  kit.poses.assign(poses.begin(), poses.end());
  for (KitPose& pose : kit.poses) {
    for (Eigen::Isometry3d& link : pose) link.translation() *= unit * options.scale;
  }
  if (auto failure = checkTrain(kit)) return *std::move(failure);
  const std::optional<Vector3d> up = upOf(kit.plan, kit.train);
  if (!up) return layoutFailure(translated("The ground has no bearing that a base could hold."));
  kit.up = *up;
  pairMarks(kit);
  if (auto failure = addArms(kit)) return *std::move(failure);
  if (stop.stop_requested()) return stopped;
  if (auto failure = addWheels(kit)) return *std::move(failure);
  if (stop.stop_requested()) return stopped;
  if (auto failure = addGround(kit, placement)) return *std::move(failure);
  if (stop.stop_requested()) return stopped;
  addShafts(kit);
  if (stop.stop_requested()) return stopped;
  for (const KitPart& part : kit.parts) {
    if (stop.stop_requested()) return stopped;
    if (part.solid->empty() || !isClosed(*part.solid)) {
      return layoutFailure(
          translated("Edges of \"%1\" cross each other at this size; try another scale.", {part.name}));
    }
  }
  numberNames(kit.parts);
  KitAssembly assembly;
  for (const KitPart& part : kit.parts) assembly.add(part);
  const auto overlap = assembly.overlap(stop);
  if (stop.stop_requested()) return stopped;
  if (overlap) return overlapFailure(kit, overlap->first, overlap->second);
  for (const KitPose& pose : kit.poses) {
    for (std::size_t a = 0; a < kit.parts.size(); ++a) {
      for (std::size_t b = 0; b < a; ++b) {
        if (stop.stop_requested()) return stopped;
        const LinkOrdinal one = kit.parts[a].link, other = kit.parts[b].link;
        if (one != other && assembly.overlaps(a, b, pose[one], pose[other])) return overlapFailure(kit, b, a);
      }
    }
  }
  PrintKit made;
  made.options = options;
  made.up = kit.up;
  auto plates = platesFor(kit.parts, options);
  if (auto* failure = std::get_if<KitFailure>(&plates)) return std::move(*failure);
  made.plates = std::get<std::vector<KitPlate>>(std::move(plates));
  made.steps = assembly.order(kit.parts, waysOf(kit), stop);
  if (stop.stop_requested()) return stopped;
  for (const TrainGear& gear : kit.train.gears) made.gears.push_back(gear.spec);
  made.parts = std::move(kit.parts);
  std::sort(kit.screws.begin(), kit.screws.end(),
            [](const KitScrew& a, const KitScrew& b) { return a.length < b.length; });
  made.screws = std::move(kit.screws);
  made.marks = std::move(kit.marks);
  made.notes = std::move(kit.notes);
  return made;
}

}  // namespace geargraph
