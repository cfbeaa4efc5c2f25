#pragma once

#include <string>
#include <vector>

#include "core/foundations/base/expected.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph {

// Edits of brakes, clutches and states: pure functions, as in edits.h. Couplings go with withoutElements().

/// Adds a brake on the link, or a clutch between two; an empty `id` is replaced by the first free capital
/// letter. Rejects unknown-id, self-joint, duplicate-id, and schema for a brake on the ground.
[[nodiscard]] Expected<Mechanism> withBrake(Mechanism mechanism, LinkId link, const std::string& id = {});
[[nodiscard]] Expected<Mechanism> withClutch(Mechanism mechanism, LinkId one, LinkId other,
                                             const std::string& id = {});

/// `first` may not turn faster than `second` (Coupling); one of them may be the ground.
[[nodiscard]] Expected<Mechanism> withFreewheel(Mechanism mechanism, LinkId first, LinkId second,
                                                const std::string& id = {});

/// Changes the id of a coupling, also in states. Rejects unknown-id, duplicate-id and an empty id.
[[nodiscard]] Expected<Mechanism> withCouplingRenamed(Mechanism mechanism, ShiftElementId coupling,
                                                      const std::string& name);

/// Appends a state, named with the first free whole number; drive and driven are those of the state before
/// it.
[[nodiscard]] Expected<Mechanism> withState(Mechanism mechanism);

/// `state`, here and below: the position in the document. @pre there is such a state
[[nodiscard]] Expected<Mechanism> withoutState(Mechanism mechanism, int state);
/// Rejects duplicate-id and the empty name.
[[nodiscard]] Expected<Mechanism> withStateRenamed(Mechanism mechanism, int state, const std::string& name);
/// Engages or releases a coupling in a state. Rejects a freewheel that is to be engaged, which no state
/// names. Engaged ones are in the order of the document's couplings.
[[nodiscard]] Expected<Mechanism> withEngaged(Mechanism mechanism, int state, ShiftElementId coupling,
                                              bool engaged);
/// Sets the links whose speeds define the ratio, of one state; of all with `state` -1.
[[nodiscard]] Expected<Mechanism> withDrive(Mechanism mechanism, int state, LinkId drive);
[[nodiscard]] Expected<Mechanism> withDriven(Mechanism mechanism, int state, LinkId driven);

/// Engages exactly these couplings now (Mechanism::engaged), in the order of the document's couplings; with
/// an empty list it releases all. Inputs stay as they are; withCouplingsEngaged() (theory/states) adapts
/// them. Rejects unknown-id, and duplicate-id for a coupling that is listed twice.
[[nodiscard]] Expected<Mechanism> withEngagement(Mechanism mechanism,
                                                 const std::vector<ShiftElementId>& engaged);

/// Is this brake or clutch engaged in the document?
[[nodiscard]] bool isEngaged(const Mechanism& mechanism, ShiftElementId coupling);
/// Are exactly the couplings of this state engaged in the document, whatever freewheels do? True for all
/// states with the same couplings, which differ in their drive; false if nothing is engaged. @pre there is
/// such a state
[[nodiscard]] bool isEngaged(const Mechanism& mechanism, int state);
/// The position of the engaged state; among several with the same couplings the one whose drive is at the
/// first input; -1 for none.
[[nodiscard]] int engagedState(const Mechanism& mechanism);

}  // namespace geargraph
