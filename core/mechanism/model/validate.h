#pragma once

#include "core/foundations/base/diagnostic.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph {

/// The violations of well-formedness: duplicate-id, unknown-id, self-joint, and schema for teeth, directions,
/// couplings, loads (load_checks.h) and the limits of the format (limits.h). All of them, not only the first.
/// The reader rejects a file with any. Cost: O(n + t + c).
[[nodiscard]] Diagnostics wellFormedDiagnostics(const Mechanism& mechanism);

/// An error in the limits of a joint, as a sentence: a range that does not contain the reference pose (0), or
/// that is a single angle; std::nullopt if they are valid.
[[nodiscard]] std::optional<std::string> limitsProblem(const JointLimits& limits);

/// Why the turning joints are no spanning tree: `disconnected` (one diagnostic with all links that no chain
/// of turning joints connects to the ground) and `turning-loop` (one for each joint that closes a loop, with
/// the loop, until a million joints of loops have been named).
/// @pre the mechanism is well formed
/// Cost: O(n + t), and the length of each loop.
[[nodiscard]] Diagnostics treeDiagnostics(const Mechanism& mechanism);

}  // namespace geargraph
