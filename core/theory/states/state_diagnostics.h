#pragma once

#include <vector>

#include "core/foundations/base/diagnostic.h"
#include "core/mechanism/model/mechanism.h"
#include "core/theory/states/state_solution.h"

namespace geargraph {

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

/// state-free, for freewheels of which more than one pattern of locked and free ones is possible, `found` one
/// of them, and for those that would have to lock where they are not pushed: the drive overruns.
[[nodiscard]] Diagnostic freewheelsOpen(const Mechanism& mechanism, const ShiftState& state,
                                        const std::vector<StateSolution::Freewheel>& found);
[[nodiscard]] Diagnostic freewheelsOverrun(const Mechanism& mechanism, const ShiftState& state,
                                           const std::vector<StateSolution::Freewheel>& wanted);

/// turning-loop: the coupling connects links across four directions of axes or more. `state`: in which it is
/// engaged; null: in the document's current engagement.
[[nodiscard]] Diagnostic couplingLinkage(const Mechanism& mechanism, const ShiftElement& coupling,
                                         const ShiftState* state);

/// freewheel-direction: the first link would turn faster than the second by `slip`, rad/s.
[[nodiscard]] Diagnostic freewheelDirection(const Mechanism& mechanism, const ShiftElement& freewheel,
                                            const Rational& slip);

/// turning-loop: the links of the clutch do not turn about one line against each other.
[[nodiscard]] Diagnostic clutchAxes(const Mechanism& mechanism, const ShiftElement& clutch);

/// The ratio of the state is beyond the largest double.
[[nodiscard]] Diagnostic ratioBeyondRange(const ShiftState& state);

}  // namespace geargraph
