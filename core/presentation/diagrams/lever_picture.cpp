#include "core/presentation/diagrams/lever_picture.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/foundations/base/position_index.h"
#include "core/theory/levers/lever_motion.h"
#include "core/theory/states/engagement.h"

namespace geargraph {
namespace {

/// Torque 1 per tooth in a mesh, as torques of links on the lever; the ground has what is left to 0.
std::vector<std::pair<LinkOrdinal, Rational>> unitTorques(const KinematicModel& model, MeshOrdinal mesh) {
  const KinematicModel::MeshRow& row = model.meshRow(mesh);
  const std::array<int, 4> weights{row.tailTeeth, -row.tailTeeth, -row.sign * row.headTeeth,
                                   row.sign * row.headTeeth};
  std::vector<std::pair<LinkOrdinal, Rational>> torques;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (row.links[i] != 0) torques.emplace_back(row.links[i], weights[i]);
  }
  return torques;
}

/// The torques at the points of one lever; empty where self-stresses leave them open.
std::vector<Rational> torquesOn(const LeverPlan& plan, const Lever& lever, const KinematicModel& model,
                                const StaticsReport& report) {
  const StaticsSolution& solution = report.solution();
  const std::size_t streams = 1 + solution.selfStresses.size();
  std::vector<std::vector<Rational>> sums(streams, std::vector<Rational>(lever.points.size()));
  const auto place = [&](LinkOrdinal link) -> std::ptrdiff_t {
    const LeverPoint* const point = lever.pointOf(link);
    return point == nullptr ? -1 : point - lever.points.data();
  };
  const std::ptrdiff_t ground = place(0);
  const auto add = [&](std::size_t stream, MeshOrdinal mesh, const Rational& torque) {
    if (torque.isZero()) return;
    for (const auto& [link, weight] : unitTorques(model, mesh)) {
      const std::ptrdiff_t at = place(link);
      if (at < 0) continue;  // off the axis: its torques are in balance
      sums[stream][static_cast<std::size_t>(at)] += weight * torque;
      if (ground >= 0) sums[stream][static_cast<std::size_t>(ground)] -= weight * torque;
    }
  };
  for (const int group : lever.groups) {
    for (const MeshOrdinal mesh : plan.groups[static_cast<std::size_t>(group)].meshes) {
      const auto unknown = static_cast<std::size_t>(int{mesh});
      const Real& value = solution.values[unknown];
      add(0, mesh, value.isExact() ? Rational(*value.fraction()) : Rational::fromDouble(value.number()));
      for (std::size_t stress = 0; stress < solution.selfStresses.size(); ++stress) {
        for (const auto& [member, weight] : solution.selfStresses[stress]) {
          if (member == int{mesh}) add(1 + stress, mesh, weight);
        }
      }
    }
  }
  for (std::size_t stress = 1; stress < streams; ++stress) {
    if (std::any_of(sums[stress].begin(), sums[stress].end(),
                    [](const Rational& each) { return !each.isZero(); }))
      return {};
  }
  return std::move(sums[0]);
}

}  // namespace

LeverPicture leverPicture(const Mechanism& mechanism, const Placement& placement, LeverPlan plan,
                          std::span<const int> inputs, std::span<const Rational> rates) {
  LeverPicture picture;
  picture.plan = std::move(plan);
  for (const int coupling : engagedCouplings(mechanism)) picture.engaged.emplace_back(coupling);
  if (picture.plan.mainAxis < 0) return picture;
  if (!rates.empty()) picture.speeds = leverSpeeds(picture.plan, placement, rates);
  for (const int joint : inputs) {
    const LinkOrdinal link = placement.tree->child[JointOrdinal(joint)];
    if (placement.tree->parent[link] == 0 && picture.plan.positionOf(link) >= 0)
      picture.inputs.push_back(link);
  }
  const PositionIndex<LinkTag> linkAt(mechanism.links);
  const auto sorted = [](std::vector<ShiftElementId> ids) {
    std::sort(ids.begin(), ids.end());
    return ids;
  };
  for (const ShiftState& state : mechanism.states) {
    if (picture.output || !state.driven || sorted(state.engaged) != sorted(mechanism.engaged)) continue;
    picture.output = linkAt.at(*state.driven);
  }
  return picture;
}

std::vector<std::vector<Rational>> leverTorques(const LeverPlan& plan, const KinematicModel& model,
                                                const StaticsReport& report) {
  std::vector<std::vector<Rational>> torques;
  for (const Lever& lever : plan.levers) torques.push_back(torquesOn(plan, lever, model, report));
  return torques;
}

}  // namespace geargraph
