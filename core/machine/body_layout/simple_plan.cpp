#include "core/machine/body_layout/simple_plan.h"

#include <algorithm>
#include <map>
#include <vector>

#include "core/machine/body_layout/nested_shafts.h"
#include "core/machine/body_layout/shaft_extents.h"
#include "core/machine/teeth/wheel_kind.h"

namespace geargraph {
namespace {

/// Bearings of an axis stand in a row outside of its wheels, on the bearings' side: nearest the one whose
/// link has its wheels nearest to that end, so that the shafts of the others, which come from farther in, are
/// the inner ones.
void placeInRow(PlanDraft& draft, AxisGroupOrdinal axisGroup) {
  AxisLayout& layout = draft.axis(axisGroup);
  const int side = layout.bearingSide;
  double end = -1e300;  // of all wheels, towards the bearings' side
  std::map<int, double> depths;
  for (const Interval& s : layout.wheels) {
    const double edge = side < 0 ? -s.low : s.high;
    end = std::max(end, edge);
    const auto [known, isNew] = depths.try_emplace(s.link, edge);
    if (!isNew) known->second = std::max(known->second, edge);
  }
  const auto depthOf = [&](LinkOrdinal link) {
    const auto found = depths.find(link);
    return found == depths.end() ? -1e300 : found->second;
  };
  std::vector<Bearing*> row;
  for (Bearing& bearing : layout.bearings) row.push_back(&bearing);
  std::stable_sort(row.begin(), row.end(),
                   [&](const Bearing* a, const Bearing* b) { return depthOf(a->child) > depthOf(b->child); });
  double at = end + layout.gap() + layout.width() / 2;
  for (Bearing* bearing : row) {
    if (!layout.wheels.empty()) {
      bearing->at = side * at;
      at += layout.width() + layout.gap();
    }
    bearing->placed = true;
  }
}

}  // namespace

void planWithoutRouting(PlanDraft& draft) {
  draft.plan.isSimple = true;
  for (const GearOrdinal g : draft.train.gears.ordinals()) {
    const TrainGear& gear = draft.train.gears[g];
    if (!isRing(gear.spec)) continue;
    AxisLayout& layout = draft.axis(gear.axisGroup);
    const double plate = layout.coordinate(gear.pose.translation()) +
                         layout.bearingSide * (gear.spec.faceWidth / 2 + layout.gap() + layout.width() / 2);
    draft.plan.ringCarriers.push_back({static_cast<int>(g), layout.bearingSide, plate});
    layout.wheels.push_back({plate - layout.width() / 2, plate + layout.width() / 2, gear.link});
  }
  for (std::size_t c = 0; c < draft.plan.axes.size() && !draft.isStopped(); ++c) {
    placeInRow(draft, static_cast<int>(c));
    for (const Bearing& bearing : draft.plan.axes[c].bearings) {
      const AxisGroupOrdinal home = draft.placement.classes->classOfLink(bearing.parent);
      if (bearing.parent == 0 || home == static_cast<int>(c)) continue;
      const double level = draft.axis(home).coordinate(draft.plan.axes[c].at(bearing.at));
      draft.addArm({bearing.parent, home, level, static_cast<int>(c), bearing.at, bearing.child});
    }
  }
  for (std::size_t link = 1; link < draft.heldBy.size() && !draft.isStopped(); ++link)
    addShaft(draft, draft.placement.classes->classOfLink(static_cast<int>(link)), static_cast<int>(link));
  addFixedHubs(draft);
  for (std::size_t c = 0; c < draft.plan.axes.size() && !draft.isStopped(); ++c)
    nestShafts(draft, static_cast<int>(c));
}

}  // namespace geargraph
