#pragma once

#include <optional>
#include <stop_token>
#include <vector>

#include "core/theory/matroid/structure.h"

namespace geargraph::inline matroid {

/// An equation that follows from others, and from which: together they close a loop that carries load but
/// constrains nothing. From c() on they are rows of engaged couplings (KinematicModel::heldRow()).
struct Redundancy {
  int equation = 0;
  std::vector<int> dependsOn;  ///< equations that are not redundant themselves, ascending
};

/// The redundant equations: of all choices the latest, so that a planet added last is the one named, and a
/// coupling before any mesh. Their number is equations() - rank. Nothing where `stop` was requested. Cost:
/// that of an elimination, and of the loops.
[[nodiscard]] std::optional<std::vector<Redundancy>> redundanciesOf(const KinematicModel& model,
                                                                    const FusedField& field,
                                                                    const std::stop_token& stop = {});

}  // namespace geargraph::inline matroid
