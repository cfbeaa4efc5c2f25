#pragma once

#include <vector>

#include "core/foundations/base/expected.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph {

// Edits of what is engaged now. The inputs follow, so that they stay a valid set of the train as engaged:
// those that couplings now determine are no longer driven, joints that become free are driven at their
// present speed. So releasing keeps the motion, and engaging keeps what the couplings still let turn. Inputs
// that the document leaves to the program stay so.
//
// Rejects turning-loop for a coupling that closes a linkage. Locking the train is no error; the diagnostics
// report it. Cost: two eliminations of the train.

/// Exactly these couplings are engaged; with an empty list all are released. Rejects unknown-id, and
/// duplicate-id for a coupling that is listed twice.
[[nodiscard]] Expected<Mechanism> withCouplingsEngaged(Mechanism mechanism,
                                                       const std::vector<ShiftElementId>& engaged);
/// One coupling is engaged or released, the others stay. Rejects unknown-id.
[[nodiscard]] Expected<Mechanism> withCouplingEngaged(Mechanism mechanism, ShiftElementId coupling,
                                                      bool engaged);

/// Engages the couplings of a state and no others; the first input drives its `drive` at 1 rad/s (by another
/// joint at the corresponding speed where the drive's own joint cannot turn).
/// @pre there is such a state
[[nodiscard]] Expected<Mechanism> withStateEngaged(Mechanism mechanism, int state);

}  // namespace geargraph
