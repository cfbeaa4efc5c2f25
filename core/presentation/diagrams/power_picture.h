#pragma once

#include <vector>

#include "core/theory/statics/statics_report.h"

namespace geargraph {

/// Power that an element delivers to a link, W; below 0: it takes power from the link.
struct DrawnPort {
  LinkOrdinal link = 0;  ///< ordinal
  double power = 0;
  double circulating = 0;  ///< the circulating part of it, with the same sign
};

/// The drawn power of one element.
struct DrawnFlow {
  ElementId element;             ///< a mesh, a joint, a coupling; the link of a load or a balance on it
  std::vector<DrawnPort> ports;  ///< without the ground, if it is at rest
  double lost = 0;               ///< in a mesh, W
  bool isDetermined = true;      ///< else its load is indeterminate
  bool isAssumed = false;        ///< its load is determined only by the assumption of equal stiffness
  /// For a mesh with an indeterminate or assumed load: its weight in each self-stress. Meshes of equal gears
  /// whose weights sum to 0 in every self-stress have a determinate sum.
  std::vector<double> members;
};

/// A loop of circulating power.
struct DrawnLoop {
  double power = 0;
  std::vector<int> links;   ///< labels
  std::vector<int> meshes;  ///< labels
};

/// The power flow of a train in a motion, for drawing.
struct PowerPicture {
  std::vector<DrawnFlow> flows;  ///< those that pass power
  std::vector<DrawnLoop> loops;  ///< the greatest first; seen from the ground
  LinkOrdinal observer = 0;      ///< label of the observing link
  double fed = 0;                ///< into the train, W, seen from the ground
  double largest = 0;            ///< of all ports

  [[nodiscard]] bool isEmpty() const { return flows.empty() || largest <= 0; }
};

/// Empty without equilibrium or motion. Cost: O(n + c), for an observer other than the ground that of
/// powerFlow(). @pre all of one mechanism; the observer is a link
[[nodiscard]] PowerPicture powerPicture(const Mechanism& mechanism, const KinematicModel& model,
                                        const Placement& placement, const StaticsReport& report,
                                        LinkOrdinal observer = 0);

}  // namespace geargraph
