#include "core/machine/body_layout/arrangement.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "core/machine/body_layout/body_clashes.h"
#include "core/machine/body_layout/body_planner.h"
#include "core/machine/body_layout/ground_frame.h"
#include "core/machine/body_layout/simple_plan.h"
#include "core/machine/solids/gear_body.h"

namespace geargraph {
namespace {

/// Carriers that turn about the axes of bearings which the frame cannot reach, and the levels of their arms.
std::map<int, double> armsRound(const Arrangement& plan) {
  std::map<int, double> arms;
  for (const auto& place : plan.frame.onPedestals) {
    for (const ArmPlan& arm : plan.arms) {
      if (arm.link != 0 && arm.from == place.first) arms.try_emplace(arm.link, arm.level);
    }
  }
  return arms;
}

}  // namespace

Arrangement arrangementOf(const Mechanism& mechanism, const Placement& placement, const GearTrain& train,
                          const std::stop_token& stop) {
  // Arms of the frame across the train that run into something go: their bearings stand on pedestals of their
  // own. And the frame leaves room for carriers that find none, or that go round bearings it cannot reach.
  PlanTries tries;
  if (train.gears.size() > kMaxRoutedGears) {
    PlanDraft draft(mechanism, placement, train, tries, stop);
    planWithoutRouting(draft);
    return std::move(draft.plan);
  }
  struct Tried {
    Arrangement plan;
    std::vector<BodyClash> clashes;

    /// The fewer, the better: first what passes through others, then what the frame cannot reach.
    [[nodiscard]] std::pair<std::size_t, std::size_t> faults() const {
      return {plan.blocked.size() + clashes.size(), plan.frame.onPedestals.size()};
    }
  };
  std::optional<Tried> best;
  constexpr int kMaxTries = 16;
  bool isNew = true;
  for (int i = 0; isNew && i < kMaxTries; ++i) {
    isNew = false;
    PlanDraft draft(mechanism, placement, train, tries, stop);
    planBodies(draft);
    Tried tried{std::move(draft.plan), {}};
    if (stop.stop_requested()) return std::move(tried.plan);
    tried.clashes = bodyClashes(tried.plan, train, stop);
    tried.plan.frame = planFrame(tried.plan, train, placement);
    for (const LinkOrdinal link : draft.wantSlots) isNew = tries.slotsFor.insert(link).second || isNew;
    for (const BodyClash& clash : tried.clashes) {
      for (const int child : clash.heldByFrame) isNew = tries.onPedestals.insert(child).second || isNew;
    }
    for (const auto& [link, level] : armsRound(tried.plan)) {
      const bool isFirst = tries.roundBearings.try_emplace(link, level).second;
      isNew = isFirst || tries.slotsFor.insert(link).second || isNew;
    }
    if (!best || tried.faults() < best->faults()) best = std::move(tried);
  }
  Arrangement& plan = best->plan;
  const auto isReported = [&](const std::vector<int>& pair) {
    return std::any_of(plan.blocked.begin(), plan.blocked.end(), [&](const std::vector<LinkOrdinal>& links) {
      return std::all_of(pair.begin(), pair.end(), [&](LinkOrdinal link) {
        return std::find(links.begin(), links.end(), link) != links.end();
      });
    });
  };
  for (const BodyClash& clash : best->clashes) {
    if (!isReported({clash.one, clash.other})) plan.blocked.push_back({clash.one, clash.other});
  }
  return std::move(plan);
}

std::vector<AxisPlace> placesAlong(const Arrangement& arrangement, const GearTrain& train,
                                   AxisGroupOrdinal axisGroup) {
  const AxisLayout& axis = arrangement.axes[axisGroup];
  std::vector<AxisPlace> places;
  using Kind = AxisPlace::Kind;
  for (const GearOrdinal g : train.gears.ordinals()) {
    const TrainGear& gear = train.gears[g];
    if (gear.axisGroup != axisGroup) continue;
    const AxialSpan span = axialSpan(gear.spec);
    const double sense = gear.pose.linear().col(2).dot(axis.direction) < 0 ? -1 : 1;
    const double middle = axis.coordinate(gear.pose.translation()) + sense * (span.low + span.high) / 2;
    places.push_back({Kind::wheel, middle, gear.link, static_cast<int>(g)});
  }
  for (const Bearing& b : axis.bearings) {
    if (b.isBoss()) places.push_back({Kind::bearing, b.at, b.child, b.joint});
  }
  for (std::size_t a = 0; a < arrangement.arms.size(); ++a) {
    const ArmPlan& arm = arrangement.arms[a];
    if (arm.from == axisGroup) places.push_back({Kind::arm, arm.level, arm.link, static_cast<int>(a)});
  }
  for (const RingCarrierPlan& ringCarrier : arrangement.ringCarriers) {
    const TrainGear& ring = train.gears[ringCarrier.gear];
    if (ring.axisGroup == axisGroup)
      places.push_back({Kind::ringCarrier, ringCarrier.plate, ring.link, ringCarrier.gear});
  }
  std::stable_sort(places.begin(), places.end(),
                   [](const AxisPlace& a, const AxisPlace& b) { return a.at < b.at; });
  return places;
}

std::vector<int> nestingDepths(const Arrangement& arrangement) {
  std::vector<int> depths(arrangement.shafts.size(), 0);
  for (std::size_t c = 0; c < arrangement.axes.size(); ++c) {
    const AxisLayout& axis = arrangement.axes[c];
    std::vector<std::size_t> byRadius = arrangement.shaftsOn[c];
    std::stable_sort(byRadius.begin(), byRadius.end(), [&](std::size_t a, std::size_t b) {
      return arrangement.shafts[a].outer < arrangement.shafts[b].outer;
    });
    for (const std::size_t o : byRadius) {
      const ShaftSegment& outer = arrangement.shafts[o];
      for (const std::size_t i : byRadius) {
        const ShaftSegment& inner = arrangement.shafts[i];
        const bool isWithin = inner.outer < outer.outer && inner.link != outer.link &&
                              axis.overlap(inner.low, inner.high, outer.low, outer.high);
        if (isWithin) depths[o] = std::max(depths[o], depths[i] + 1);
      }
    }
  }
  return depths;
}

int nestingDepth(const Arrangement& arrangement, AxisGroupOrdinal axisGroup, LinkOrdinal link) {
  const std::vector<int> depths = nestingDepths(arrangement);
  int deepest = -1;
  for (const std::size_t s : arrangement.shaftsOn[axisGroup]) {
    if (arrangement.shafts[s].link == link) deepest = std::max(deepest, depths[s]);
  }
  return deepest;
}

}  // namespace geargraph
