#include "core/machine/body_layout/body_planner.h"

#include <vector>

#include "core/machine/body_layout/coaxial_plan.h"
#include "core/machine/body_layout/cross_shaft_bosses.h"
#include "core/machine/body_layout/eccentrics.h"
#include "core/machine/body_layout/intersecting_arms.h"
#include "core/machine/body_layout/nested_shafts.h"
#include "core/machine/body_layout/parallel_arms.h"
#include "core/machine/body_layout/ring_carriers.h"
#include "core/machine/body_layout/shaft_extents.h"

namespace geargraph {
namespace {

/// Linked sets: sleeves, discs and drums of one axis, with the bearings and arms on it.
void planCoaxial(PlanDraft& draft, AxisGroupOrdinal axisGroup) {
  if (!needsCoaxialPlan(axisGroup, draft.placement, draft.train)) return;
  const auto plan = coaxialPlan(axisGroup, draft.plan.axes, draft.placement, draft.train, draft.stop);
  if (!plan) {
    draft.plan.blocked.emplace_back();
    for (const Bearing& b : draft.axis(axisGroup).bearings) draft.plan.blocked.back().push_back(b.child);
    return;
  }
  draft.coaxial[axisGroup] = true;
  draft.axis(axisGroup).thickness = plan->width;
  for (const CoaxialBearing& placed : plan->bearings) {
    const int c = draft.placement.classes->classOf[placed.joint];
    draft.axis(c).thickness = plan->width;
    for (Bearing& b : draft.axis(c).bearings) {
      if (b.joint != placed.joint) continue;
      b.at = placed.at;
      b.form = placed.form;
      b.placed = true;
    }
  }
  for (const ShaftSegment& shaft : plan->shafts) draft.addSegment(shaft);
  for (const ArmPlan& arm : plan->arms) draft.addArm(arm);
  draft.plan.pins.insert(draft.plan.pins.end(), plan->pins.begin(), plan->pins.end());
  draft.plan.revolvedBodies.insert(draft.plan.revolvedBodies.end(), plan->revolvedBodies.begin(),
                                   plan->revolvedBodies.end());
  draft.plan.walls.insert(draft.plan.walls.end(), plan->walls.begin(), plan->walls.end());
  draft.plan.cages.insert(draft.plan.cages.end(), plan->cages.begin(), plan->cages.end());
  draft.plan.hubs.insert(draft.plan.hubs.end(), plan->hubs.begin(), plan->hubs.end());
}

/// Bearings and arms of what a link holds.
void placeLink(PlanDraft& draft, LinkOrdinal link) {
  const auto& held = draft.heldBy[static_cast<std::size_t>(link)];
  if (held.empty()) return;
  const AxisGroupOrdinal home = homeOf(draft, link);
  if (link == 0) reserveSlots(draft);
  for (const auto& [c, b] : held) {
    Bearing& bearing = draft.axis(c).bearings[b];
    if (link != 0 && !bearing.placed && isEccentric(draft, home, c))
      placeEccentric(draft, link, home, bearing);
  }
  for (const auto& round : roundsOf(draft, link, home)) {
    if (draft.isStopped()) return;
    placeParallel(draft, link, home, round);
  }
  for (std::size_t i = 0; i < held.size(); ++i) {
    const int c = held[i].first;
    if (!draft.parallel(home, c) && (i == 0 || held[i - 1].first != c))
      placeCrossShaftBoss(draft, link, home, c);
  }
  for (const auto& [c, b] : held) {
    if (draft.isStopped()) return;
    if (!draft.parallel(home, c) && !draft.axis(c).bearings[b].placed)
      placeIntersecting(draft, link, home, draft.axis(c).bearings[b]);
  }
  if (link == 0) releaseSlots(draft);
}

}  // namespace

void planBodies(PlanDraft& draft) {
  const int axes = static_cast<int>(draft.plan.axes.size());
  for (int c = 0; c < axes && !draft.isStopped(); ++c) planCoaxial(draft, c);
  placeRingCarriers(draft);
  const std::vector<int> links = draft.placement.tree->breadthFirst();
  for (const LinkOrdinal link : links) {
    if (draft.isStopped()) return;
    placeLink(draft, link);
  }
  for (const LinkOrdinal link : links) {
    if (draft.isStopped()) return;
    if (link == 0) continue;
    const int c = draft.placement.classes->classOfLink(link);
    if (!draft.isCoaxial(c)) addShaft(draft, c, link);
  }
  addFixedHubs(draft);
  for (const PinPlan& pin : draft.plan.pins) addShaft(draft, pin.axisGroup, pin.link);
  for (int c = 0; c < axes; ++c) {
    if (!draft.isCoaxial(c)) nestShafts(draft, c);
  }
  trimCrossShaftBosses(draft);
}

}  // namespace geargraph
