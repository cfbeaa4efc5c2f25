#pragma once

#include "core/foundations/base/diagnostic.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph::inline model {

/// What wellFormedDiagnostics() finds about loads, balances, efficiencies and coefficients of friction:
/// unknown-id; duplicate-id for the id of a load, or what is balanced, twice; schema for a load or balance on
/// the ground, an efficiency out of 0 < eta <= 1, a coefficient of friction out of 0..1, or both on one mesh.
/// Cost: O(n + t + c).
[[nodiscard]] Diagnostics loadDiagnostics(const Mechanism& mechanism);

/// What is wrong with the losses of a mesh (or of gearDefaults), in a sentence: the member, the sentence.
struct LossProblem {
  const char* member = "";
  std::string message;
};
[[nodiscard]] std::optional<LossProblem> lossProblem(const std::optional<Number>& efficiency,
                                                     const std::optional<Number>& friction);

}  // namespace geargraph::inline model
