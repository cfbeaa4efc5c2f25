#pragma once

#include <vector>

#include "core/theory/statics/statics_report.h"

namespace geargraph::inline power_drawing {

/// Power that an element delivers to a link, W; below 0: what it takes from it.
struct DrawnPort {
  int link = 0;  ///< ordinal
  double power = 0;
  double circulating = 0;  ///< the part of it that goes round in a loop, with the same sign
};

/// What is drawn of one element's power.
struct DrawnFlow {
  ElementId element;             ///< a mesh, a joint, a coupling; the link of a load or a balance on it
  std::vector<DrawnPort> ports;  ///< without the ground, where it does not move
  double lost = 0;               ///< in a mesh, W
  bool isDetermined = true;      ///< else it shares its load in unknown parts
  bool isAssumed = false;        ///< its share is decided by equal stiffness, an assumption
  /// Of such a mesh, by self-stress: its weight in it. Meshes of equal gears whose weights add up to 0 in all
  /// of them are determined together.
  std::vector<double> members;
};

/// Power that goes round, with what it passes.
struct DrawnLoop {
  double power = 0;
  std::vector<int> links;   ///< labels
  std::vector<int> meshes;  ///< labels
};

/// Where the power of a train goes in a motion, as a picture shows it.
struct PowerPicture {
  std::vector<DrawnFlow> flows;  ///< those that pass power
  std::vector<DrawnLoop> loops;  ///< the greatest first; seen from the ground
  int observer = 0;              ///< label of the link that it is seen from
  double fed = 0;                ///< into the train, W, seen from the ground
  double largest = 0;            ///< of all ports

  [[nodiscard]] bool isEmpty() const { return flows.empty() || largest <= 0; }
};

/// Empty where there is no equilibrium or no motion. Cost: O(n + c), seen from another link than the ground
/// that of powerFlow(). @pre all of one mechanism; the observer is a link
[[nodiscard]] PowerPicture powerPicture(const Mechanism& mechanism, const KinematicModel& model,
                                        const Placement& placement, const StaticsReport& report,
                                        int observer = 0);

}  // namespace geargraph::inline power_drawing
