#include "core/mechanism/geometry_edits/fitting_guards.h"

#include <algorithm>
#include <cmath>

#include "core/mechanism/geometry_edits/fitted_edits.h"
#include "core/mechanism/geometry_edits/module_fit.h"
#include "core/mechanism/geometry_edits/pin_rejection.h"
#include "core/mechanism/model/limits.h"
#include "core/mechanism/model/pins.h"
#include "core/mechanism/placement/tolerance.h"

namespace geargraph {
namespace {

/// Meshes whose module is pinned and another one now.
Diagnostics brokenPins(const PlacedMechanism& placedBefore, const PlacedMechanism& placedAfter) {
  const Mechanism& before = placedBefore.mechanism();
  const Mechanism& edited = placedAfter.mechanism();
  Diagnostics broken;
  for (MeshOrdinal mesh = 0; mesh < std::min(before.c(), edited.c()); ++mesh) {
    const GearMesh& element = before.gearMeshes[mesh];
    if (!isPinned(element) || edited.gearMeshes[mesh].id != element.id) continue;
    const auto was = moduleOf(before, placedBefore.placement(), mesh);
    const auto is = moduleOf(edited, placedAfter.placement(), mesh);
    if (was && is && std::abs(*is - *was) > kGeometryFits * *was)
      broken.push_back(modulePinRejection(before, mesh));
  }
  return broken;
}

}  // namespace

bool canBeFitted(const Placement& placement) {
  if (placement.meshes.size() > kMaxFittedMeshes) return false;
  return placement.tree && std::all_of(placement.meshes.begin(), placement.meshes.end(),
                                       [](const auto& mesh) { return mesh.has_value(); });
}

Expected<PlacedMechanism> unlessBroken(const PlacedMechanism& before, Expected<Mechanism> edited) {
  if (edited) edited = checkedLimits(std::move(edited).value());
  if (!edited) return edited.error();
  PlacedMechanism after = std::move(edited).value();
  Diagnostics broken;
  for (const Diagnostic& diagnostic : after.placement().diagnostics) {
    if (diagnostic.severity() == Severity::error) broken.push_back(diagnostic);
  }
  if (broken.empty()) broken = brokenPins(before, after);
  if (!broken.empty()) return broken;
  return after;
}

}  // namespace geargraph
