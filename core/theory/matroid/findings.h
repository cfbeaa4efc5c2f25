#pragma once

#include <span>
#include <stop_token>

#include "core/theory/matroid/matroid_analysis.h"

namespace geargraph::inline matroid {

/// The diagnostics of the kinematics: redundant-mesh, redundant-coupling, locked, dead-joint, idle-joint,
/// no-meshes and invalid-inputs. `wanted`: the document's inputs, as joint ordinals.
[[nodiscard]] Diagnostics findingsOf(const Mechanism& mechanism, const KinematicModel& model,
                                     const Placement& placement, const MatroidAnalysis& analysis,
                                     std::span<const int> wanted, const std::stop_token& stop);

/// The forced relation behind a rejected input, over the inputs of the choice: "q10 = -i15 q8"; "q5 = 0"
/// where the joint cannot turn. In the ratios i_k where that is short enough, else in numbers.
[[nodiscard]] std::string forcedRelation(const Mechanism& mechanism, const KinematicModel& model,
                                         const Placement& placement, const MatroidAnalysis& analysis,
                                         int joint, const std::stop_token& stop);

}  // namespace geargraph::inline matroid
