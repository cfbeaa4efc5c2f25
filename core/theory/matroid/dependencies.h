#pragma once

#include <optional>
#include <stop_token>
#include <vector>

#include "core/theory/matroid/structure.h"

namespace geargraph::inline matroid {

/// A mesh whose row follows from the rows of others, and which: together they close a loop that carries load
/// but constrains nothing.
struct Redundancy {
  int mesh = 0;
  std::vector<int> dependsOn;  ///< meshes that are not redundant themselves, ascending
};

/// The redundant meshes: of all choices the latest in the document, so that a planet added last is the one
/// named. Their number is c - rank. Nothing where `stop` was requested. Cost: that of an elimination, and of
/// the loops.
[[nodiscard]] std::optional<std::vector<Redundancy>> redundanciesOf(const KinematicModel& model,
                                                                    const FusedField& field,
                                                                    const std::stop_token& stop = {});

}  // namespace geargraph::inline matroid
