#pragma once

#include <vector>

#include "core/foundations/base/expected.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph::inline states {

// Edits of what is engaged now. The inputs follow, so that they stay a valid set of the train as engaged:
// those that couplings now decide are driven no longer, joints that come free are driven at the speed that
// they have. So releasing leaves the motion as it is, and engaging leaves of it what the couplings let turn.
// Inputs that the document leaves to the program stay so.
//
// Rejected is turning-loop, for a coupling that closes a linkage. What locks the train is no error: its
// findings tell. Cost: two eliminations of the train.

/// Exactly these couplings are engaged; with an empty list all are released. Rejects unknown-id, and
/// duplicate-id for a coupling that is listed twice.
[[nodiscard]] Expected<Mechanism> withCouplingsEngaged(Mechanism mechanism,
                                                       const std::vector<CouplingId>& engaged);
/// One coupling is engaged or released, the others stay. Rejects unknown-id.
[[nodiscard]] Expected<Mechanism> withCouplingEngaged(Mechanism mechanism, CouplingId coupling, bool engaged);

/// A state is put in: its couplings, and no others, are engaged, and its drive turns at 1 rad/s by the first
/// input (another joint at the speed that goes with it, where the drive's own joint does not turn).
/// @pre there is such a state
[[nodiscard]] Expected<Mechanism> withStateEngaged(Mechanism mechanism, int state);

}  // namespace geargraph::inline states
