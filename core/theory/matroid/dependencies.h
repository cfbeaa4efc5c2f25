#pragma once

#include <optional>
#include <stop_token>
#include <vector>

#include "core/theory/matroid/structure.h"

namespace geargraph {

/// An equation that follows from others, with those others: together they close a loop that can carry
/// internal load but adds no constraint. From c() on they are rows of engaged couplings
/// (KinematicModel::heldRow()).
struct Redundancy {
  int equation = 0;
  std::vector<int> dependsOn;  ///< equations that are not redundant themselves, ascending
};

/// The redundant equations: of all possible choices the last in order, so that the planet added last is
/// named, and a coupling rather than a mesh. Their number is equations() - rank. std::nullopt if `stop` was
/// requested. Cost: that of an elimination, and of the loops.
[[nodiscard]] std::optional<std::vector<Redundancy>> redundanciesOf(const KinematicModel& model,
                                                                    const ModularDoubleField& field,
                                                                    const std::stop_token& stop = {});

}  // namespace geargraph
