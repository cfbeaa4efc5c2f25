#pragma once

#include <algorithm>
#include <cmath>
#include <stop_token>
#include <vector>

#include "core/machine/bodies/body_parts.h"
#include "core/machine/train/axis_layout.h"
#include "core/machine/train/train.h"
#include "core/mechanism/placement/placement.h"

namespace geargraph::inline bodies {

/// Where bodies go: bearings beside the wheels, arms where they pass them, shafts nested.
struct BodyPlan {
  std::vector<AxisLayout> axes;
  std::vector<ArmPlan> arms;
  std::vector<ShaftSegment> shafts;
  std::vector<CupPlan> cups;
  std::vector<PinPlan> pins;
  std::vector<TeePlan> tees;
  std::vector<LathePlan> lathes;
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

/// Plans the bodies. Greedy, links nearest the ground first; once more where arms of the frame are in the way
/// or a carrier found no room beside it, a few times at most. Deterministic.
/// Cost: O(links * things on an axis). Of no use when `stop` was requested meanwhile.
[[nodiscard]] BodyPlan planBodies(const Mechanism& mechanism, const Placement& placement,
                                  const GearTrain& train, const std::stop_token& stop = {});

}  // namespace geargraph::inline bodies
