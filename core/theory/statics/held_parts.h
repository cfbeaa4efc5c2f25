#pragma once

#include <vector>

#include "core/mechanism/model/mechanism.h"
#include "core/theory/states/engagement.h"
#include "core/theory/statics/applied_loads.h"

namespace geargraph {

/// One unknown torque that holds links: that of an engaged coupling about one direction, or of a balance. A
/// brake acts on its link, a clutch on the first link that it names (the second one has the reaction); about
/// the first axis on the way from that link to the ground. Where the axes between the two links are not
/// parallel, a coupling has one part per direction, the others about the direction of an axis class's line.
struct HeldPart {
  ShiftElementOrdinal coupling = -1;  ///< position in the document; -1: a balance
  int balance = -1;                   ///< position in StaticsProblem::balances; -1: a coupling
  AxisOrdinal axis = -1;              ///< of the document, gives the direction; -1 for a balance in a joint
  bool isMain = true;   ///< of a coupling: about the first axis; else one of its further directions
  bool isExact = true;  ///< the factors below are exact; else rounded from irrational cosines
  /// The power for the torque 1, as (link, factor): sum of factor * phi_link of the kinematic model.
  std::vector<std::pair<int, Rational>> byLink;
  /// The same over the joints' rates: the coefficients of the f-circuit of a chord from the ground (or the
  /// second link) to the link.
  std::vector<std::pair<int, Rational>> byJoint;

  /// Does the part alone hold a load with this power for unit speeds, in every motion: does the load act
  /// where the part does? False for a load without power.
  [[nodiscard]] bool holds(const RadicalColumns& load) const;
};

/// The torques of the engaged couplings and of the balances, in this order.
/// Cost: O(joints between their links). @pre the placement has a tree
[[nodiscard]] std::vector<HeldPart> heldParts(const Mechanism& mechanism, const KinematicModel& model,
                                              const Placement& placement, const StaticsProblem& problem);

}  // namespace geargraph
