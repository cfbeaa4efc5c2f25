#pragma once

#include <optional>
#include <stop_token>
#include <vector>

#include "core/theory/matroid/structure.h"

namespace geargraph::inline matroid {

/// Meshes whose rows together say that a joint stands still: the loop that locks it.
struct LockedLoop {
  std::vector<int> meshes;  ///< ascending
  std::vector<int> joints;  ///< dead joints for which these meshes alone are the reason, ascending
};

/// The loops behind the dead joints, none of them part of another. Looks at the first 200 dead joints at
/// most. Nothing where `stop` was requested. Cost: an elimination, and O(n + c) for each dead joint.
[[nodiscard]] std::optional<std::vector<LockedLoop>> lockedLoops(const KinematicModel& model,
                                                                 const FusedField& field,
                                                                 const std::vector<char>& dead,
                                                                 const std::stop_token& stop = {});

}  // namespace geargraph::inline matroid
