#pragma once

#include "core/presentation/stage/stage_forces.h"
#include "core/theory/statics/statics_report.h"

namespace geargraph::inline train_stage {

/// The tooth forces on the heads' gears and the bearing reactions on the heads' links of a solved report, at
/// their points; empty without loads or equilibrium, or where the unit of length is not known. Indeterminate
/// forces are left out. Cost: O(meshes + joints). @pre all of one mechanism
[[nodiscard]] std::vector<StageForce> stageForces(const Mechanism& mechanism, const Placement& placement,
                                                  const StaticsReport& report);

}  // namespace geargraph::inline train_stage
