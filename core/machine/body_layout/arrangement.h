#pragma once

#include <algorithm>
#include <cmath>
#include <stop_token>
#include <vector>

#include "core/machine/body_layout/axis_layout.h"
#include "core/machine/body_layout/body_parts.h"
#include "core/machine/train/train.h"
#include "core/mechanism/placement/placement.h"

namespace geargraph {

/// The layout of the bodies of a train along its axes: bearings, shafts and their nesting, ring-gear
/// carriers, arms, and the frame of the ground. The 3D bodies and the schematic are made from it. Lengths in
/// the document's unit, unless in modules.
///
/// Guaranteed for every train:
/// * A pure function of mechanism, placement and train; every joint has one bearing, on its axis class.
/// * A shaft holds the hubs of its link's wheels on the axis, its arms and its bearing.
/// * Shafts that overlap on an axis are nested: the radii of different links are disjoint.
/// * Brackets and base of the frame stay clear of what moving parts sweep (ground_frame.h).
/// * Parts that could not be routed without collision are listed in `blocked` and `frame.onPedestals`.
/// Guaranteed where `blocked` is empty: arms and shafts are clear of the wheels of other links, on parallel
/// axes in every pose, else in the reference pose. Not for trains of more than kMaxRoutedGears (`isSimple`).
/// Optimised, in this order: nothing blocked; bearings that the frame can reach; short arms; bearings where
/// the document has them. Heuristic: links are placed greedily from the ground outwards, several times with
/// the results of the previous tries (PlanTries), and the best try is kept: a train may be blocked although a
/// valid arrangement exists. Axes with several rings are routed in their half plane (profile_router.h).
struct Arrangement {
  ByClass<AxisLayout> axes;
  std::vector<ArmPlan> arms;
  std::vector<ShaftSegment> shafts;
  std::vector<RingCarrierPlan> ringCarriers;
  std::vector<PinPlan> pins;
  std::vector<CrossShaftBossPlan> crossShaftBosses;
  std::vector<RevolvedPlan> revolvedBodies;
  std::vector<WallPlan>
      walls;  ///< the discs and walls of `revolvedBodies` and `cages`, by their middle surfaces
  std::vector<CagePlan> cages;
  std::vector<PedestalPlan> pedestals;
  FramePlan frame;
  /// Links whose arms, shafts or discs cannot be routed past each other: carrier and carried, or the links of
  /// one axis.
  std::vector<std::vector<LinkOrdinal>> blocked;
  std::vector<std::pair<std::size_t, double>> hubs;  ///< gears, and the required diameter of their hub
  ByClass<std::vector<std::size_t>> shaftsOn;        ///< shafts
  bool isSimple = false;                             ///< the train is too large for routing

  /// The link's shaft on the axis, of several the one nearest to the coordinate `near`; null: it has none.
  [[nodiscard]] const ShaftSegment* shaftOf(AxisGroupOrdinal axisGroup, LinkOrdinal link, double near) const {
    const ShaftSegment* found = nullptr;
    const auto away = [&](const ShaftSegment& s) { return std::max({s.low - near, near - s.high, 0.0}); };
    for (const std::size_t s : shaftsOn[axisGroup]) {
      if (shafts[s].link != link) continue;
      if (found == nullptr || away(shafts[s]) < away(*found)) found = &shafts[s];
    }
    return found;
  }
  /// Outer radius of the widest shaft at a place of an axis, of links other than `link`; 0: none.
  [[nodiscard]] double shaftAt(AxisGroupOrdinal axisGroup, double coordinate, LinkOrdinal link) const {
    double radius = 0;
    for (const std::size_t i : shaftsOn[axisGroup]) {
      const ShaftSegment& s = shafts[i];
      if (s.low <= coordinate && coordinate <= s.high && s.link != link) radius = std::max(radius, s.outer);
    }
    return radius;
  }
};

/// An item on an axis, in the order of its coordinate.
struct AxisPlace {
  enum class Kind { wheel, bearing, arm, ringCarrier };
  Kind kind = Kind::wheel;
  double at = 0;         ///< coordinate along the axis class
  LinkOrdinal link = 0;  ///< that it belongs to; for a bearing the link that turns in it
  int index =
      0;  ///< position of the wheel or ring in the train, of the arm in the arrangement; else the joint
};

/// The items on an axis, ascending: wheels, visible bearings, arms that start there, ring-gear carriers.
/// Cost: linear in the size of the arrangement.
[[nodiscard]] std::vector<AxisPlace> placesAlong(const Arrangement& arrangement, const GearTrain& train,
                                                 AxisGroupOrdinal axisGroup);

/// By shaft of the arrangement: how many shafts of other links are nested within it. Cost: O(shafts^2) per
/// axis.
[[nodiscard]] std::vector<int> nestingDepths(const Arrangement& arrangement);

/// The greatest nesting depth of a link's shafts on an axis; -1: it has none.
[[nodiscard]] int nestingDepth(const Arrangement& arrangement, AxisGroupOrdinal axisGroup, LinkOrdinal link);

/// The arrangement of a train. Deterministic. Cost: O(links * items on an axis) per try, at most 16 tries;
/// some milliseconds for axes with several rings. The result is meaningless if `stop` was requested
/// meanwhile.
[[nodiscard]] Arrangement arrangementOf(const Mechanism& mechanism, const Placement& placement,
                                        const GearTrain& train, const std::stop_token& stop = {});

}  // namespace geargraph
