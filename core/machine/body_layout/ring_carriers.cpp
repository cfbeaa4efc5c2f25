#include "core/machine/body_layout/ring_carriers.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/machine/solids/gear_body.h"
#include "core/machine/teeth/wheel_kind.h"

namespace geargraph {

using Eigen::Vector3d;

namespace {

constexpr int kFlange = -3;  ///< in place of a link: kept free for the flange of a carrier

/// Does a plate of the ring's ring carrier at this place cut through planets that have wheels on both of its
/// sides?
bool cutsPlanets(const PlanDraft& draft, const TrainGear& ring, double plate) {
  const AxisLayout& own = draft.axis(ring.axisGroup);
  const double half = own.width() / 2 + own.gap() / 2;
  return std::any_of(draft.train.gears.begin(), draft.train.gears.end(), [&](const TrainGear& gear) {
    const int c = gear.axisGroup;
    if (c == ring.axisGroup || !draft.parallel(ring.axisGroup, c)) return false;
    const Vector3d apart = draft.axis(c).point - own.point;
    if ((apart - apart.dot(own.direction) * own.direction).norm() > rimDiameter(ring.spec) / 2) return false;
    const auto span = draft.axis(c).wheelsOf(gear.link);
    const auto [low, high] = std::minmax(
        {draft.carried(c, span->low, ring.axisGroup), draft.carried(c, span->high, ring.axisGroup)});
    return own.overlap(low, high, plate - half, plate + half);
  });
}

/// Do the ring's teeth mesh with planets that a carrier on the ring's axis holds, so that the carrier may
/// have a flange between them and the ring's plate?
bool enclosesPlanets(const PlanDraft& draft, const TrainGear& ring) {
  return std::any_of(draft.train.gears.begin(), draft.train.gears.end(), [&](const TrainGear& gear) {
    const auto isMesh = [&](MeshOrdinal mesh) {
      return std::find(ring.meshes.begin(), ring.meshes.end(), mesh) != ring.meshes.end();
    };
    if (&gear == &ring || !std::any_of(gear.meshes.begin(), gear.meshes.end(), isMesh)) return false;
    const AxisGroups& classes = *draft.placement.classes;
    const LinkOrdinal rootLink = classes.classes[gear.axisGroup].rootLink;
    if (rootLink == 0 || classes.classOfLink(rootLink) != ring.axisGroup) return false;
    const auto& held = draft.heldBy[static_cast<std::size_t>(rootLink)];
    return classes.classes[ring.axisGroup].rootLink == 0 &&
           std::all_of(held.begin(), held.end(),
                       [&](const auto& place) { return draft.parallel(ring.axisGroup, place.first); });
  });
}

/// The face of a ring that its other wheels on the axis call for, or that lets wheels inside out which the
/// frame holds; 0: neither.
int ringCarrierSideFor(const PlanDraft& draft, const TrainGear& ring) {
  const AxisLayout& own = draft.axis(ring.axisGroup);
  const double middle = own.coordinate(ring.pose.translation());
  double others = 0;
  for (const GearOrdinal g : draft.gearsOn[ring.axisGroup]) {
    const TrainGear& gear = draft.train.gears[g];
    if (gear.link == ring.link) others += own.coordinate(gear.pose.translation()) - middle;
  }
  if (std::abs(others) > own.module) return others < 0 ? -1 : 1;
  const bool holdsFixed = std::any_of(ring.meshes.begin(), ring.meshes.end(), [&](MeshOrdinal mesh) {
    return std::any_of(draft.train.gears.begin(), draft.train.gears.end(), [&](const TrainGear& gear) {
      const bool meshes = std::find(gear.meshes.begin(), gear.meshes.end(), mesh) != gear.meshes.end();
      return meshes && gear.axisGroup != ring.axisGroup &&
             draft.placement.classes->classes[gear.axisGroup].rootLink == 0;
    });
  });
  return holdsFixed ? -own.bearingSide : 0;
}

}  // namespace

void placeRingCarriers(PlanDraft& draft) {
  for (const GearOrdinal g : draft.train.gears.ordinals()) {
    const TrainGear& gear = draft.train.gears[g];
    if (!isRing(gear.spec) || draft.isCoaxial(gear.axisGroup)) continue;
    AxisLayout& layout = draft.axis(gear.axisGroup);
    const double middle = layout.coordinate(gear.pose.translation());
    const double reach = gear.spec.faceWidth / 2 + layout.gap() + layout.width() / 2;
    const int wanted = ringCarrierSideFor(draft, gear);
    int side = wanted != 0 ? wanted : layout.bearingSide;
    const auto isOpen = [&](int towards) {
      const double plate = middle + towards * reach;
      return layout.slotIsFree(plate) && !cutsPlanets(draft, gear, plate);
    };
    if (!isOpen(side) && (isOpen(-side) || !layout.slotIsFree(middle + side * reach))) side = -side;
    const double flange = middle + side * reach, plate = flange + side * (layout.width() + layout.gap());
    const bool hasFlange = enclosesPlanets(draft, gear) && isOpen(side) && layout.slotIsFree(plate) &&
                           !cutsPlanets(draft, gear, plate);
    if (hasFlange)
      layout.occupied.push_back({flange - layout.width() / 2, flange + layout.width() / 2, kFlange});
    draft.plan.ringCarriers.push_back({static_cast<int>(g), side, hasFlange ? plate : flange});
    layout.occupy(draft.plan.ringCarriers.back().plate, gear.link);
  }
}

}  // namespace geargraph
