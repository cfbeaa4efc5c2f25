#pragma once

#include "core/foundations/base/diagnostic.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph::inline model {

/// Is the document well formed: duplicate-id, unknown-id, self-joint, and schema for teeth, directions,
/// couplings, loads (load_checks.h) and what is beyond the limits of the format (limits.h). All findings, not
/// only the first. The reader refuses what has any. Cost: O(n + t + c).
[[nodiscard]] Diagnostics wellFormedDiagnostics(const Mechanism& mechanism);

/// What is wrong with the limits of a joint, in a sentence: an end beyond the reference pose, which is at 0,
/// or nowhere to turn to.
[[nodiscard]] std::optional<std::string> limitsProblem(const JointLimits& limits);

/// Do the turning joints make a spanning tree: `disconnected` (one finding, all links that no chain of
/// turning joints ties to the ground) and `turning-loop` (one finding for each joint that closes a loop, the
/// loop named, until a million joints of loops are named).
/// @pre the mechanism is well formed
/// Cost: O(n + t), and the length of each loop.
[[nodiscard]] Diagnostics treeDiagnostics(const Mechanism& mechanism);

}  // namespace geargraph::inline model
