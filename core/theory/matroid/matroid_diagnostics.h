#pragma once

#include <span>
#include <stop_token>

#include "core/theory/matroid/matroid_analysis.h"

namespace geargraph {

/// The diagnostics of the kinematics: redundant-mesh, redundant-coupling, locked, dead-joint, idle-joint,
/// no-meshes and invalid-inputs. Redundancy that follows from equal planets is one note per set of planets,
/// after the others. `wanted`: the document's inputs, as joint ordinals.
[[nodiscard]] Diagnostics matroidDiagnostics(const Mechanism& mechanism, const KinematicModel& model,
                                             const Placement& placement, const MatroidAnalysis& analysis,
                                             std::span<const int> wanted, const std::stop_token& stop);

/// Why an input was rejected: the relation that fixes its rate, in terms of the inputs of the choice: "q10 =
/// -i15 q8"; "q5 = 0" if the joint cannot turn. In the ratios i_k if that is short enough, else in numbers.
[[nodiscard]] std::string forcedRelation(const Mechanism& mechanism, const KinematicModel& model,
                                         const Placement& placement, const MatroidAnalysis& analysis,
                                         JointOrdinal joint, const std::stop_token& stop);

}  // namespace geargraph
