#pragma once

#include <algorithm>
#include <cmath>
#include <stop_token>
#include <vector>

#include "core/machine/arrangement/axis_layout.h"
#include "core/machine/arrangement/body_parts.h"
#include "core/machine/train/train.h"
#include "core/mechanism/placement/placement.h"

namespace geargraph::inline arrangement {

/// What is placed where on each axis of a train: bearings, shafts and their nesting, ring-gear carriers,
/// arms, and the frame of the ground. The bodies in 3D and the schematic are drawn from it.
///
/// Always, of every train:
/// * A pure function of mechanism, placement and train; every joint has one bearing, on its axis class.
/// * A shaft holds the hubs of its link's wheels on the axis, its arms and its bearing.
/// * Shafts that overlap on an axis are nested: the radii of different links are disjoint.
/// * Brackets and base of the frame stay clear of what moving parts sweep (ground_frame.h).
/// * What found no way is listed in `blocked` and `frame.onFeet`.
/// Guaranteed where `blocked` is empty: arms and shafts pass the wheels of others, on parallel axes in every
/// pose, else in the reference pose. Not for trains of more than kMostRoutedGears (`isSimple`).
/// Wanted, in this order: nothing blocked; bearings that the frame can reach; short arms; bearings where the
/// document has them.
/// Heuristic: links are placed greedily from the ground outwards, several times with what the former tries
/// showed (PlanTries), and the best try is kept: a train may be blocked although an arrangement exists. Axes
/// with several rings are routed in their half plane (meridian_router.h).
struct Arrangement {
  std::vector<AxisLayout> axes;
  std::vector<ArmPlan> arms;
  std::vector<ShaftSegment> shafts;
  std::vector<CupPlan> cups;
  std::vector<PinPlan> pins;
  std::vector<TeePlan> tees;
  std::vector<LathePlan> lathes;
  std::vector<WallPlan> walls;  ///< what the lathes and cages show, by its middle
  std::vector<CagePlan> cages;
  std::vector<StubPlan> stubs;
  FramePlan frame;
  /// Links whose arms, shafts or discs have no way past the others: carrier and carried, or the links of one
  /// axis.
  std::vector<std::vector<int>> blocked;
  std::vector<std::pair<std::size_t, double>> hubs;  ///< gears, and the diameter that their hub has to have
  std::vector<std::vector<std::size_t>> shaftsOn;    ///< shafts by axis class
  bool isSimple = false;                             ///< the train is too large for routes

  /// The link's shaft on the axis, of several the one nearest to the coordinate.
  [[nodiscard]] const ShaftSegment* shaftOf(int axisClass, int link, double near) const {
    const ShaftSegment* found = nullptr;
    const auto away = [&](const ShaftSegment& s) { return std::max({s.low - near, near - s.high, 0.0}); };
    for (const std::size_t s : shaftsOn[static_cast<std::size_t>(axisClass)]) {
      if (shafts[s].link != link) continue;
      if (found == nullptr || away(shafts[s]) < away(*found)) found = &shafts[s];
    }
    return found;
  }
  /// Outer radius of the widest shaft at a place of an axis, of links other than `link`; 0: none.
  [[nodiscard]] double shaftAt(int axisClass, double coordinate, int link) const {
    double radius = 0;
    for (const std::size_t i : shaftsOn[static_cast<std::size_t>(axisClass)]) {
      const ShaftSegment& s = shafts[i];
      if (s.low <= coordinate && coordinate <= s.high && s.link != link) radius = std::max(radius, s.outer);
    }
    return radius;
  }
};

/// Something on an axis, in the order of its coordinate.
struct AxisPlace {
  enum class Kind { wheel, bearing, arm, ringCarrier };
  Kind kind = Kind::wheel;
  double at = 0;  ///< coordinate along the axis class
  int link = 0;   ///< whose it is; of a bearing the link that turns in it
  int index =
      0;  ///< position of the wheel or ring in the train, of the arm in the arrangement; else the joint
};

/// What is placed on an axis, ascending: wheels, bearings that show, arms that start there, ring-gear
/// carriers. Cost: O(everything).
[[nodiscard]] std::vector<AxisPlace> placesAlong(const Arrangement& arrangement, const GearTrain& train,
                                                 int axisClass);

/// By shaft of the arrangement: how many shafts of other links are nested within it. Cost: O(shafts^2) an
/// axis.
[[nodiscard]] std::vector<int> nestingDepths(const Arrangement& arrangement);

/// The greatest of a link's shafts on an axis; -1: it has none.
[[nodiscard]] int nestingDepth(const Arrangement& arrangement, int axisClass, int link);

/// The arrangement of a train. Deterministic. Cost: O(links * things on an axis) a try, 16 at most; some
/// milliseconds for axes with several rings. Of no use when `stop` was requested meanwhile.
[[nodiscard]] Arrangement arrangementOf(const Mechanism& mechanism, const Placement& placement,
                                        const GearTrain& train, const std::stop_token& stop = {});

}  // namespace geargraph::inline arrangement
