#pragma once

#include <optional>
#include <stop_token>
#include <vector>

#include "core/theory/matroid/structure.h"

namespace geargraph {

/// Equations that together hold a joint still: the loop of meshes, and of engaged couplings, that locks it.
struct LockedLoop {
  std::vector<int> equations;  ///< ascending; from c() on rows of engaged couplings
  std::vector<int> joints;     ///< dead joints that these equations alone lock, ascending
};

/// The loops that lock the dead joints; none is part of another. Looks at the first 200 dead joints at most.
/// std::nullopt if `stop` was requested. Cost: an elimination, and O(n + c) for each dead joint.
[[nodiscard]] std::optional<std::vector<LockedLoop>> lockedLoops(const KinematicModel& model,
                                                                 const ModularDoubleField& field,
                                                                 const std::vector<char>& dead,
                                                                 const std::stop_token& stop = {});

}  // namespace geargraph
