#include "core/machine/body_layout/nested_shafts.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/machine/body_layout/coaxial_sections.h"
#include "core/machine/solids/gear_body.h"
#include "core/machine/teeth/wheel_kind.h"

namespace geargraph {
namespace {

/// Largest radius that the bores of the link's wheels on this axis allow.
double boreRoom(const PlanDraft& draft, AxisGroupOrdinal axisGroup, LinkOrdinal link) {
  double room = 1e300;
  for (const GearOrdinal g : draft.gearsOn[axisGroup]) {
    const TrainGear& gear = draft.train.gears[g];
    if (gear.link != link || isRing(gear.spec)) continue;
    room = std::min(room, shaftRoom(gear.spec));
  }
  return room;
}

/// How many wheels, ring carriers and arms of a link another shaft on the axis would cut through if it went
/// about the link's own.
int cutsBy(const PlanDraft& draft, const ShaftSegment& outer, LinkOrdinal link) {
  const AxisLayout& layout = draft.axis(outer.axisGroup);
  const auto isCut = [&](double low, double high) {
    return layout.overlap(low, high, outer.low, outer.high) ? 1 : 0;
  };
  const double half = layout.width() / 2;
  int cuts = 0;
  for (const GearOrdinal g : draft.gearsOn[outer.axisGroup]) {
    const TrainGear& gear = draft.train.gears[g];
    if (gear.link != link || isRing(gear.spec)) continue;
    const Interval wheel = draft.intervalOf(gear, axialSpan(gear.spec));
    cuts += isCut(wheel.low, wheel.high);
  }
  for (const RingCarrierPlan& ringCarrier : draft.plan.ringCarriers) {
    const TrainGear& ring = draft.train.gears[ringCarrier.gear];
    if (ring.link == link && ring.axisGroup == outer.axisGroup)
      cuts += isCut(ringCarrier.plate - half, ringCarrier.plate + half);
  }
  for (const std::size_t a : draft.armsOf[link]) {
    const ArmPlan& arm = draft.plan.arms[a];
    if (arm.from == outer.axisGroup) cuts += isCut(arm.level - half, arm.level + half);
  }
  return cuts;
}

}  // namespace

void nestShafts(PlanDraft& draft, AxisGroupOrdinal axisGroup) {
  std::vector<ShaftSegment*> open;
  for (const std::size_t s : draft.plan.shaftsOn[axisGroup]) {
    open.push_back(&draft.plan.shafts[s]);
  }
  const double module = draft.axis(axisGroup).module;
  const auto length = [&](const ShaftSegment* s) {
    return std::round((s->high - s->low) / (kEqual * module));
  };
  std::stable_sort(open.begin(), open.end(),
                   [&](const ShaftSegment* a, const ShaftSegment* b) { return length(a) > length(b); });
  std::vector<ShaftSegment*> shafts;
  while (!open.empty()) {
    const auto cuts = [&](const ShaftSegment* inner) {
      int sum = 0;
      for (const ShaftSegment* outer : open) {
        if (outer->link != inner->link &&
            draft.axis(axisGroup).overlap(outer->low, outer->high, inner->low, inner->high))
          sum += cutsBy(draft, *outer, inner->link);
      }
      return sum;
    };
    const auto next =
        std::min_element(open.begin(), open.end(),
                         [&](const ShaftSegment* a, const ShaftSegment* b) { return cuts(a) < cuts(b); });
    shafts.push_back(*next);
    open.erase(next);
  }
  double scale = 1;
  for (std::size_t i = 0; i < shafts.size(); ++i) {
    ShaftSegment& shaft = *shafts[i];
    double inside = 0;
    for (std::size_t k = 0; k < i; ++k) {
      const bool over = draft.axis(axisGroup).overlap(shafts[k]->low, shafts[k]->high, shaft.low, shaft.high);
      if (over) inside = std::max(inside, shafts[k]->outer);
    }
    shaft.wrap(inside, module);
    scale = std::min(scale, boreRoom(draft, axisGroup, shaft.link) / shaft.outer);
  }
  for (ShaftSegment* shaft : shafts) {
    shaft->inner *= scale;
    shaft->outer *= scale;
  }
}

}  // namespace geargraph
