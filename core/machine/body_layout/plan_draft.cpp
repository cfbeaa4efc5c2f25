#include "core/machine/body_layout/plan_draft.h"

#include <algorithm>
#include <cmath>

namespace geargraph {

using Eigen::Vector3d;

PlanDraft::PlanDraft(const Mechanism& mechanism, const Placement& placed, const GearTrain& wheels,
                     const PlanTries& former, const std::stop_token& token)
    : placement(placed), train(wheels), tries(former), stop(token), obstacles(wheels) {
  plan.axes = axisLayouts(mechanism, placement, train, stop);
  plan.shaftsOn.resize(plan.axes.size());
  gearsOn.resize(plan.axes.size());
  coaxial.resize(plan.axes.size(), false);
  heldBy.resize(mechanism.links.size());
  armsOf.resize(mechanism.links.size());
  for (const GearOrdinal g : train.gears.ordinals()) {
    gearsOn[train.gears[g].axisGroup].push_back(g);
  }
  for (std::size_t c = 0; c < plan.axes.size(); ++c) {
    for (std::size_t b = 0; b < plan.axes[c].bearings.size(); ++b) {
      heldBy[static_cast<std::size_t>(plan.axes[c].bearings[b].parent)].push_back({static_cast<int>(c), b});
    }
  }
}

std::optional<std::pair<double, double>> PlanDraft::intersectionOf(AxisGroupOrdinal a,
                                                                   AxisGroupOrdinal b) const {
  const AxisLayout& one = axis(a);
  const AxisLayout& other = axis(b);
  const Vector3d across = one.direction.cross(other.direction);
  const Vector3d apart = other.point - one.point;
  if (across.norm() < 1e-6 || std::abs(apart.dot(across)) > 0.01 * one.module * across.norm())
    return std::nullopt;
  const double level = apart.cross(other.direction).dot(across) / across.squaredNorm();
  return std::pair{level, other.coordinate(one.at(level))};
}

Interval PlanDraft::intervalOf(const TrainGear& gear, const AxialSpan& span) const {
  const AxisLayout& layout = axis(gear.axisGroup);
  const double sense = gear.pose.linear().col(2).dot(layout.direction) < 0 ? -1 : 1;
  const double origin = layout.coordinate(gear.pose.translation());
  const auto [low, high] = std::minmax({origin + sense * span.low, origin + sense * span.high});
  return {low, high, gear.link};
}

}  // namespace geargraph
