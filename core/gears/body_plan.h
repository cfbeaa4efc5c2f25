#pragma once

#include <algorithm>
#include <vector>

#include "core/gears/axis_layout.h"

namespace geargraph {

/// An arm of a link from its own axis to the bearing of another.
struct ArmPlan {
  int link = 0;
  int from = 0;      ///< axis class it starts at
  double level = 0;  ///< coordinate along it
  int to = 0;        ///< axis class of the bearing
  double at = 0;     ///< coordinate of the bearing
  int child = 0;     ///< whose shaft the bearing holds
};

/// The stretch of an axis that one link holds: a shaft, or a tube about the shafts inside.
struct ShaftPlan {
  int axisClass = 0;
  int link = 0;
  double low = 1e300;
  double high = -1e300;
  double inner = 0;
  double outer = 0;

  void include(double from, double to) {
    low = std::min(low, from);
    high = std::max(high, to);
  }
};

/// A pin that a link holds out along an axis that crosses its own, for a child that turns on it.
struct PinPlan {
  int link = 0;
  int home = 0;      ///< the link's axis class
  double level = 0;  ///< coordinate of the crossing along it
  int axisClass = 0;
  double from = 0;  ///< of the crossing along the pin's axis
  double to = 0;    ///< behind the child's last wheel
};

/// The plate and wall that carry a ring on its link's shaft.
struct CupPlan {
  int gear = 0;
  int side = -1;     ///< the ring's face that it closes
  double plate = 0;  ///< coordinate of the plate's middle
};

/// Where bodies go: bearings beside the wheels, arms where they pass them, shafts nested.
struct BodyPlan {
  std::vector<AxisLayout> axes;
  std::vector<ArmPlan> arms;
  std::vector<ShaftPlan> shafts;
  std::vector<CupPlan> cups;
  std::vector<PinPlan> pins;
  std::vector<std::vector<std::size_t>> shaftsOn;  ///< shafts by axis class

  [[nodiscard]] const ShaftPlan* shaftOf(int axisClass, int link) const {
    for (const std::size_t s : shaftsOn[static_cast<std::size_t>(axisClass)]) {
      if (shafts[s].link == link) return &shafts[s];
    }
    return nullptr;
  }
  /// Outer radius of the widest shaft at a place of an axis, of links other than `link`; 0: none.
  [[nodiscard]] double shaftAt(int axisClass, double coordinate, int link) const {
    double radius = 0;
    for (const std::size_t i : shaftsOn[static_cast<std::size_t>(axisClass)]) {
      const ShaftPlan& s = shafts[i];
      if (s.low <= coordinate && coordinate <= s.high && s.link != link) radius = std::max(radius, s.outer);
    }
    return radius;
  }
};

/// Plans the bodies. Greedy, links nearest the ground first; deterministic.
/// Cost: O(links * things on an axis).
[[nodiscard]] BodyPlan planBodies(const Mechanism& mechanism, const Placement& placement,
                                  const GearTrain& train);

}  // namespace geargraph
