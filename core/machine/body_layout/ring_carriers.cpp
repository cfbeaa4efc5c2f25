#include "core/machine/body_layout/ring_carriers.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/machine/body_layout/eccentrics.h"
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

/// The wheels that mesh with a ring.
std::vector<const TrainGear*> wheelsInside(const PlanDraft& draft, const TrainGear& ring) {
  std::vector<const TrainGear*> wheels;
  for (const TrainGear& gear : draft.train.gears) {
    const auto isMesh = [&](MeshOrdinal mesh) {
      return std::find(ring.meshes.begin(), ring.meshes.end(), mesh) != ring.meshes.end();
    };
    if (&gear != &ring && std::any_of(gear.meshes.begin(), gear.meshes.end(), isMesh))
      wheels.push_back(&gear);
  }
  return wheels;
}

/// Does the ring's wheel inside turn on a crank, whose disc is between it and the ring's plate?
bool enclosesEccentric(const PlanDraft& draft, const TrainGear& ring) {
  const auto inside = wheelsInside(draft, ring);
  return std::any_of(inside.begin(), inside.end(), [&](const TrainGear* gear) {
    return isEccentric(draft, ring.axisGroup, gear->axisGroup);
  });
}

/// Do the ring's teeth mesh with planets that a carrier on the ring's axis holds, so that the carrier may
/// have a flange between them and the ring's plate?
bool enclosesPlanets(const PlanDraft& draft, const TrainGear& ring) {
  const auto inside = wheelsInside(draft, ring);
  return std::any_of(inside.begin(), inside.end(), [&](const TrainGear* gear) {
    const AxisGroups& classes = *draft.placement.classes;
    const LinkOrdinal rootLink = classes.classes[gear->axisGroup].rootLink;
    if (rootLink == 0 || classes.classOfLink(rootLink) != ring.axisGroup) return false;
    const auto& held = draft.heldBy[static_cast<std::size_t>(rootLink)];
    return classes.classes[ring.axisGroup].rootLink == 0 &&
           std::all_of(held.begin(), held.end(),
                       [&](const auto& place) { return draft.parallel(ring.axisGroup, place.first); });
  });
}

/// The face of a ring beside which a wheel of its axis covers the planets inside, so that no carrier's arm
/// comes to them there; 0: neither or both.
int coveredSide(const PlanDraft& draft, const TrainGear& ring) {
  const AxisLayout& own = draft.axis(ring.axisGroup);
  double nearest = 1e300;  // of the planets' axes
  for (const TrainGear* gear : wheelsInside(draft, ring)) {
    const Vector3d apart = draft.axis(gear->axisGroup).point - own.point;
    nearest = std::min(nearest, (apart - apart.dot(own.direction) * own.direction).norm());
  }
  const double middle = own.coordinate(ring.pose.translation());
  bool isCovered[2] = {false, false};
  for (const GearOrdinal g : draft.gearsOn[ring.axisGroup]) {
    const TrainGear& gear = draft.train.gears[g];
    const double at = own.coordinate(gear.pose.translation());
    if (isRing(gear.spec) || gear.link == ring.link || std::abs(at - middle) <= own.module) continue;
    if (nominalTipRadius(gear.spec) + kShaftRadius * own.module > nearest)
      isCovered[at < middle ? 0 : 1] = true;
  }
  return isCovered[0] == isCovered[1] ? 0 : isCovered[0] ? -1 : 1;
}

/// The face of a ring that its other wheels on the axis call for, or that lets wheels inside out which the
/// frame holds, or beside which nothing else reaches the planets; 0: none.
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
  if (holdsFixed) return -own.bearingSide;
  return enclosesPlanets(draft, ring) ? coveredSide(draft, ring) : 0;
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
    if (hasFlange && !enclosesEccentric(draft, gear))
      layout.occupied.push_back({flange - layout.width() / 2, flange + layout.width() / 2, kFlange});
    draft.plan.ringCarriers.push_back({static_cast<int>(g), side, hasFlange ? plate : flange});
    layout.occupy(draft.plan.ringCarriers.back().plate, gear.link);
  }
}

}  // namespace geargraph
