#pragma once

#include "core/foundations/base/diagnostic.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph {

/// What wellFormedDiagnostics() finds about loads, balances, efficiencies and coefficients of friction:
/// unknown-id; duplicate-id for two loads with one id, or two balances at one place; schema for a load or
/// balance on the ground, an efficiency out of 0 < eta <= 1, a coefficient of friction out of 0..1, or both
/// on one mesh.
/// Cost: O(n + t + c).
[[nodiscard]] Diagnostics loadDiagnostics(const Mechanism& mechanism);

/// An error in the losses of a mesh (or of gearDefaults): the JSON member, and a sentence.
struct LossProblem {
  const char* member = "";
  std::string message;
};
[[nodiscard]] std::optional<LossProblem> lossProblem(const std::optional<Number>& efficiency,
                                                     const std::optional<Number>& friction);

}  // namespace geargraph
