#pragma once

#include <span>
#include <vector>

#include "core/foundations/base/diagnostic.h"
#include "core/mechanism/model/mechanism.h"
#include "core/theory/matroid/kinematic_model.h"

namespace geargraph {

/// The couplings that the document engages, by position, ascending.
[[nodiscard]] std::vector<int> engagedCouplings(const Mechanism& mechanism);

/// The equations of a coupling while it is engaged: the velocity of the first link that it names against the
/// ground, or against the other link of a clutch, is 0. One equation for each direction of the axes along the
/// way, of the reference pose (relative_speed.h); none for a brake on the ground.
///
/// Identity  the sum over the phi and the sum over the joints' rates are the same speed.
/// Cost      O(joints between the links). @pre the placement has a tree
[[nodiscard]] std::vector<KinematicModel::HeldRow> heldRows(const Mechanism& mechanism,
                                                            const Placement& placement,
                                                            ShiftElementOrdinal coupling);

/// +1 or -1, with which the equation of heldRows() is how much faster the first link of a freewheel turns
/// than the second, in +direction of the axis of the first one's own joint (of the second one's, if the first
/// is the ground): more than 0 is the sense in which it locks. 0 where they do not turn about one direction.
[[nodiscard]] int freewheelSense(const Mechanism& mechanism, const Placement& placement,
                                 ShiftElementOrdinal freewheel);

/// freewheel-direction for each freewheel that is not engaged and that these rates of the joints would turn
/// in the sense in which it locks. @pre as heldRows()
[[nodiscard]] Diagnostics freewheelDiagnostics(const Mechanism& mechanism, const Placement& placement,
                                               const ByJoint<Rational>& rates);

/// `turning-loop/clutch-axes` for each clutch, engaged or not, between links that turn about more than one
/// line against each other. @pre as heldRows()
[[nodiscard]] Diagnostics clutchDiagnostics(const Mechanism& mechanism, const Placement& placement);

/// Do constant coefficients describe the coupling? False where it closes a linkage (relative_speed.h).
[[nodiscard]] bool closesWithoutLinkage(const Mechanism& mechanism, const Placement& placement,
                                        ShiftElementOrdinal coupling);

/// The equations of these couplings together, or why there are none.
struct Engagement {
  std::vector<KinematicModel::HeldRow> rows;
  Diagnostics diagnostics;  ///< turning-loop for each coupling that closes a linkage; then there are no rows
};
/// `state`: the state that engages them, named in the diagnostics; null: the document's `engaged`.
[[nodiscard]] Engagement engagementOf(const Mechanism& mechanism, const Placement& placement,
                                      std::span<const int> couplings, const ShiftState* state = nullptr);

}  // namespace geargraph
