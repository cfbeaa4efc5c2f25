#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "core/machine/bodies/body_clashes.h"
#include "core/machine/bodies/body_plan.h"
#include "core/machine/bodies/body_planner.h"
#include "core/machine/bodies/ground_frame.h"

namespace geargraph::inline bodies {
namespace {

/// Carriers that turn about the axes of bearings which the frame cannot reach, and the levels of their arms.
std::map<int, double> armsRound(const BodyPlan& plan) {
  std::map<int, double> arms;
  for (const auto& place : plan.frame.onFeet) {
    for (const ArmPlan& arm : plan.arms) {
      if (arm.link != 0 && arm.from == place.first) arms.try_emplace(arm.link, arm.level);
    }
  }
  return arms;
}

}  // namespace

BodyPlan planBodies(const Mechanism& mechanism, const Placement& placement, const GearTrain& train,
                    const std::stop_token& stop) {
  // Arms of the frame across the train that run into something go: their bearings stand on feet of their own.
  // And the frame leaves room for carriers that find none, or that go round bearings it cannot reach.
  PlanTries tries;
  if (train.gears.size() > kMostRoutedGears)
    return BodyPlanner(mechanism, placement, train, tries, stop).planSimply();
  struct Tried {
    BodyPlan plan;
    std::vector<BodyClash> clashes;

    /// The fewer, the better: first what passes through others, then what the frame cannot reach.
    [[nodiscard]] std::pair<std::size_t, std::size_t> faults() const {
      return {plan.blocked.size() + clashes.size(), plan.frame.onFeet.size()};
    }
  };
  std::optional<Tried> best;
  constexpr int kMostTries = 16;
  bool isNew = true;
  for (int i = 0; isNew && i < kMostTries; ++i) {
    isNew = false;
    BodyPlanner planner(mechanism, placement, train, tries, stop);
    Tried tried{planner.plan(), {}};
    if (stop.stop_requested()) return std::move(tried.plan);
    tried.clashes = bodyClashes(tried.plan, train, stop);
    tried.plan.frame = planFrame(tried.plan, train, placement);
    for (const int link : planner.wantRoom()) isNew = tries.roomFor.insert(link).second || isNew;
    for (const BodyClash& clash : tried.clashes) {
      for (const int child : clash.heldByFrame) isNew = tries.onFeet.insert(child).second || isNew;
    }
    for (const auto& [link, level] : armsRound(tried.plan)) {
      const bool isFirst = tries.roundBearings.try_emplace(link, level).second;
      isNew = isFirst || tries.roomFor.insert(link).second || isNew;
    }
    if (!best || tried.faults() < best->faults()) best = std::move(tried);
  }
  BodyPlan& plan = best->plan;
  const auto isReported = [&](const std::vector<int>& pair) {
    return std::any_of(plan.blocked.begin(), plan.blocked.end(), [&](const std::vector<int>& links) {
      return std::all_of(pair.begin(), pair.end(), [&](int link) {
        return std::find(links.begin(), links.end(), link) != links.end();
      });
    });
  };
  for (const BodyClash& clash : best->clashes) {
    if (!isReported({clash.one, clash.other})) plan.blocked.push_back({clash.one, clash.other});
  }
  return std::move(plan);
}

}  // namespace geargraph::inline bodies
