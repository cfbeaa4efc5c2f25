#pragma once

#include <vector>

#include "core/foundations/base/diagnostic.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph::inline states {

/// state-locked: `locking` are the engaged couplings each of which, released alone, would let the drive turn;
/// empty where no single one does, or where the train itself is locked (`byTrain`).
[[nodiscard]] Diagnostic stateLocked(const Mechanism& mechanism, const ShiftState& state,
                                     const std::vector<int>& locking, bool byTrain);

/// state-free: these links still turn while the drive is held.
[[nodiscard]] Diagnostic stateFree(const Mechanism& mechanism, const ShiftState& state, int dof,
                                   const std::vector<int>& links);

/// state-idle: these links turn freely beside the drive and the driven link, which are determined.
[[nodiscard]] Diagnostic stateIdle(const Mechanism& mechanism, const ShiftState& state,
                                   const std::vector<int>& links);

/// turning-loop: the coupling connects links across four directions of axes or more. `state`: in which it is
/// engaged; null: in the document's current engagement.
[[nodiscard]] Diagnostic couplingLinkage(const Mechanism& mechanism, const Coupling& coupling,
                                         const ShiftState* state);

/// turning-loop: the links of the clutch do not turn about one line against each other.
[[nodiscard]] Diagnostic clutchAxes(const Mechanism& mechanism, const Coupling& clutch);

/// The ratio of the state is beyond the largest double.
[[nodiscard]] Diagnostic ratioBeyondRange(const ShiftState& state);

}  // namespace geargraph::inline states
