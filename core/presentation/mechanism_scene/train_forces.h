#pragma once

#include "core/presentation/scene3d/scene_forces.h"
#include "core/theory/statics/statics_report.h"

namespace geargraph {

/// The tooth forces on the heads' gears and the bearing reactions on the heads' links of a solved report, at
/// their points; empty without loads or equilibrium, or where the unit of length is not known. Indeterminate
/// forces are left out. Cost: O(meshes + joints). @pre all of one mechanism
[[nodiscard]] std::vector<SceneForce> stageForces(const Mechanism& mechanism, const Placement& placement,
                                                  const StaticsReport& report);

}  // namespace geargraph
