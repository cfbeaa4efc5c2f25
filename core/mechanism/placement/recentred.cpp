#include "core/mechanism/placement/recentred.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/mechanism/placement/tolerance.h"

namespace geargraph {
namespace {

/// Do places lose more than a small part of the smallest pitch radius to the rounding of coordinates?
bool isFar(const Placement& placement) {
  constexpr double kNegligible = 1e-9;
  double reach = 0;
  double smallest = std::numeric_limits<double>::infinity();
  for (const AxisLine& line : placement.axes) reach = std::max(reach, reachOf(line.point));
  for (const auto& mesh : placement.meshes) {
    if (mesh) smallest = std::min({smallest, std::abs(mesh->tailRadius), std::abs(mesh->headRadius)});
  }
  return roundingOf(reach) > kNegligible * smallest;
}

}  // namespace

std::optional<Recentred> recentred(const Mechanism& mechanism, const Placement& placement) {
  if (!placement.classes || !isFar(placement)) return std::nullopt;
  Placement near = placement;
  const ExactVector3 origin = exactLine(mechanism, placement, 0).point;
  for (std::size_t axis = 0; axis < near.axes.size(); ++axis) {
    near.axes[axis].point =
        exactDifference(exactLine(mechanism, placement, static_cast<int>(axis)).point, origin);
  }
  for (ExactLine& line : near.chosen) line.point = line.point - origin;
  for (auto& mesh : near.meshes) {
    if (mesh) mesh->pitchPoint = near.lineOfClass(mesh->tailClass).point + mesh->tailToPitch;
  }
  return Recentred{std::move(near), toDoubles(origin)};
}

}  // namespace geargraph
