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
/// Engages or releases a coupling. Engaged ones stand in the order of the document's couplings.
[[nodiscard]] Expected<Mechanism> withEngaged(Mechanism mechanism, int state, CouplingId coupling,
                                              bool engaged);
/// The links that make the ratio, of one state; with `state` -1 of all.
[[nodiscard]] Expected<Mechanism> withDrive(Mechanism mechanism, int state, LinkId drive);
[[nodiscard]] Expected<Mechanism> withDriven(Mechanism mechanism, int state, LinkId driven);

}  // namespace geargraph::inline model
