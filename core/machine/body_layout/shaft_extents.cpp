#include "core/machine/body_layout/shaft_extents.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/machine/body_layout/shaft_clearance.h"

namespace geargraph {
namespace {

/// Does an axis cross this one between the shaft and a place outside of it?
bool isAcross(const AxisLayout& layout, const ShaftSegment& shaft, double place) {
  const double low = std::min(shaft.high, place), high = std::max(shaft.low, place);
  return std::any_of(layout.occupied.begin(), layout.occupied.end(), [&](const Interval& s) {
    return s.link < 0 && layout.overlap(s.low, s.high, low, high);
  });
}

/// A frame has no shaft of its own: its arms begin about the shaft of the one link that it holds on their
/// axis, where no wheels of other links are in between.
std::optional<double> heldLevel(const PlanDraft& draft, AxisGroupOrdinal axisGroup, LinkOrdinal link) {
  const AxisLayout& layout = draft.axis(axisGroup);
  if (layout.bearings.size() != 1 || layout.bearings.front().child != link) return std::nullopt;
  const Bearing& bearing = layout.bearings.front();
  if (bearing.parent != 0) return std::nullopt;
  for (const std::size_t a : draft.armsOf[0]) {
    const ArmPlan& arm = draft.plan.arms[a];
    if (arm.from != axisGroup || std::abs(arm.level - bearing.at) <= kSameLevel * layout.module) continue;
    const double low = std::min(arm.level, bearing.at);
    const double high = std::max(arm.level, bearing.at);
    const bool blocked = std::any_of(layout.occupied.begin(), layout.occupied.end(), [&](const Interval& s) {
      return s.link != link && s.link != 0 && layout.overlap(s.low, s.high, low, high);
    });
    if (!blocked) return arm.level;
  }
  return std::nullopt;
}

/// A wheel of the frame that none of its bearings reaches is on a pedestal of its own, on the side where
/// nothing crosses its axis.
void addPedestal(PlanDraft& draft, AxisGroupOrdinal axisGroup, ShaftSegment& shaft) {
  AxisLayout& layout = draft.axis(axisGroup);
  const double reach = layout.gap() + layout.width() / 2;
  double place = shaft.low - reach;
  const double other = shaft.high + reach;
  const auto isBetter = [&](double x) { return layout.slotIsFree(x) && !isAcross(layout, shaft, x); };
  if (!isBetter(place) && isBetter(other)) place = other;
  shaft.include(place - layout.width() / 2, place + layout.width() / 2);
  layout.occupy(place, 0);
  draft.plan.pedestals.push_back({axisGroup, place});
}

/// True where the link has wheels here.
bool includeWheels(const PlanDraft& draft, AxisGroupOrdinal axisGroup, LinkOrdinal link,
                   ShaftSegment& shaft) {
  const Interval hubs = hubInterval(draft, axisGroup, link);
  if (hubs.low > hubs.high) return false;
  shaft.include(hubs.low, hubs.high);
  return true;
}

/// Arms, ring carriers, cross-shaft bosses and pins of the link that stand on the axis.
void includeBodies(const PlanDraft& draft, AxisGroupOrdinal axisGroup, LinkOrdinal link,
                   ShaftSegment& shaft) {
  const double half = draft.axis(axisGroup).width() / 2;
  for (const std::size_t a : draft.armsOf[link]) {
    const ArmPlan& arm = draft.plan.arms[a];
    if (arm.from == axisGroup) shaft.include(arm.level - half, arm.level + half);
  }
  if (const auto level = heldLevel(draft, axisGroup, link)) shaft.include(*level - half, *level + half);
  for (const RingCarrierPlan& ringCarrier : draft.plan.ringCarriers) {
    const TrainGear& gear = draft.train.gears[ringCarrier.gear];
    if (gear.link == link && gear.axisGroup == axisGroup)
      shaft.include(ringCarrier.plate - half, ringCarrier.plate + half);
  }
  for (const CrossShaftBossPlan& boss : draft.plan.crossShaftBosses) {
    if (boss.link == link && boss.home == axisGroup) shaft.include(boss.level, boss.level);
    if (boss.child == link && boss.axisGroup == axisGroup) shaft.include(boss.low, boss.high);
  }
  for (const PinPlan& pin : draft.plan.pins) {
    if (pin.link == link && pin.home == axisGroup) shaft.include(pin.level, pin.level);
    if (pin.link == link && pin.axisGroup == axisGroup)
      shaft.include(std::min(pin.from, pin.to), std::max(pin.from, pin.to));
  }
}

}  // namespace

void addShaft(PlanDraft& draft, AxisGroupOrdinal axisGroup, LinkOrdinal link) {
  const AxisLayout& layout = draft.axis(axisGroup);
  ShaftSegment shaft;
  shaft.axisGroup = axisGroup;
  shaft.link = link;
  const double half = layout.width() / 2;
  const bool turns = draft.placement.classes->classOfLink(link) == axisGroup;
  const bool holdsWheel = includeWheels(draft, axisGroup, link, shaft);
  includeBodies(draft, axisGroup, link, shaft);
  const Bearing* nearest = nullptr;  // what holds a wheel that does not turn here
  const auto away = [&](const Bearing& b) { return std::max({b.at - shaft.high, shaft.low - b.at, 0.0}); };
  for (const Bearing& b : layout.bearings) {
    if (!b.isBoss()) continue;
    if (b.parent == link && (nearest == nullptr || layout.isBelow(away(b), away(*nearest)))) nearest = &b;
    if (turns && (b.child == link || b.parent == link)) shaft.include(b.at - half, b.at + half);
  }
  if (!turns && nearest != nullptr && !isAcross(layout, shaft, nearest->at)) {
    shaft.include(nearest->at - half, nearest->at + half);
  } else if (link == 0 && holdsWheel) {
    addPedestal(draft, axisGroup, shaft);
  }
  if (shaft.low < shaft.high) {
    shaft.low -= 0.4 * layout.gap();  // neighbours do not touch
    shaft.high += 0.4 * layout.gap();
    draft.addSegment(shaft);
  }
}

void addFixedHubs(PlanDraft& draft) {
  for (const TrainGear& gear : draft.train.gears) {
    const bool turns = draft.placement.classes->classOfLink(gear.link) == gear.axisGroup;
    if (turns || draft.isCoaxial(gear.axisGroup)) continue;
    if (draft.plan.shaftOf(gear.axisGroup, gear.link, 0) == nullptr)
      addShaft(draft, gear.axisGroup, gear.link);
  }
}

}  // namespace geargraph
