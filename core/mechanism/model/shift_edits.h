#pragma once

#include <string>
#include <vector>

#include "core/foundations/base/expected.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph::inline model {

// Edits of brakes, clutches and states: pure functions, as in edits.h. Couplings go with withoutElements().

/// A brake on the link, or a clutch between two, named with the first free capital letter; an empty `id` asks
/// for that. Refuses unknown-id, self-joint, duplicate-id, and schema for a brake on the ground.
[[nodiscard]] Expected<Mechanism> withBrake(Mechanism mechanism, LinkId link, const std::string& id = {});
[[nodiscard]] Expected<Mechanism> withClutch(Mechanism mechanism, LinkId one, LinkId other,
                                             const std::string& id = {});

/// Another id for a coupling; states follow. Refuses unknown-id, duplicate-id and the empty one.
[[nodiscard]] Expected<Mechanism> withCouplingRenamed(Mechanism mechanism, CouplingId coupling,
                                                      const std::string& name);

/// A new state at the end, named with the first free whole number; drive and driven are those of the state
/// before it.
[[nodiscard]] Expected<Mechanism> withState(Mechanism mechanism);

/// Positions of the document's states. @pre they exist
[[nodiscard]] Expected<Mechanism> withoutState(Mechanism mechanism, int state);
/// Refuses duplicate-id and the empty name.
[[nodiscard]] Expected<Mechanism> withStateRenamed(Mechanism mechanism, int state, const std::string& name);
/// Engages or releases a coupling in a state. Engaged ones are in the order of the document's couplings.
[[nodiscard]] Expected<Mechanism> withEngaged(Mechanism mechanism, int state, CouplingId coupling,
                                              bool engaged);
/// The links that make the ratio, of one state; with `state` -1 of all.
[[nodiscard]] Expected<Mechanism> withDrive(Mechanism mechanism, int state, LinkId drive);
[[nodiscard]] Expected<Mechanism> withDriven(Mechanism mechanism, int state, LinkId driven);

/// Engages exactly these couplings now (Mechanism::engaged), in the order of the document's couplings; with
/// an empty list it releases all. Inputs stay; withCouplingsEngaged() (theory/states) makes them follow.
/// Rejects unknown-id, and duplicate-id for a coupling that is listed twice.
[[nodiscard]] Expected<Mechanism> withEngagement(Mechanism mechanism, const std::vector<CouplingId>& engaged);

/// Does the document's engagement hold just the couplings of this state? States with equal lists, which
/// differ in their drive, are engaged together; false where nothing is engaged. @pre there is such a state
[[nodiscard]] bool isEngaged(const Mechanism& mechanism, int state);
/// The position of the state that is engaged, of several with equal couplings the one whose drive is at the
/// first input; -1 for none.
[[nodiscard]] int engagedState(const Mechanism& mechanism);

}  // namespace geargraph::inline model
