#pragma once

#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "core/theory/matroid/structure.h"

namespace geargraph {

/// A valid set of inputs close to the wanted one: E joints whose rates determine all others, a basis of the
/// dual matroid of P.
struct InputChoice {
  std::vector<int> joints;    ///< the set: wanted ones in their order, then added ones by label
  std::vector<int> rejected;  ///< wanted ones that follow from the wanted ones before them, or cannot turn
  std::vector<int> added;     ///< what completes the set
  [[nodiscard]] bool wantedIsValid() const { return rejected.empty() && added.empty(); }
};

/// May the choice drive the train while couplings are engaged? Wanted inputs that follow from others are left
/// out then; none may be missing, and none wanted twice.
[[nodiscard]] bool isValidAsEngaged(const InputChoice& choice, std::span<const int> wanted);

/// Takes each wanted joint that is independent of those before it, then completes the set in the order of
/// labels. std::nullopt if `stop` was requested. Cost: O(t E) sparse steps; joints that no mesh constrains
/// cost nothing.
[[nodiscard]] std::optional<InputChoice> chooseInputs(const KinematicModel& model,
                                                      const ModularDoubleField& field,
                                                      const Structure& structure, std::span<const int> wanted,
                                                      const std::stop_token& stop = {});

}  // namespace geargraph
