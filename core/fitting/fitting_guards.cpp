#include "core/fitting/fitting_guards.h"

#include <algorithm>

#include "core/fitting/fitted_edits.h"

namespace geargraph {

bool canBeFitted(const Placement& placement) {
  if (placement.meshes.size() > kMostFittedMeshes) return false;
  return placement.tree && std::all_of(placement.meshes.begin(), placement.meshes.end(),
                                       [](const auto& mesh) { return mesh.has_value(); });
}

Expected<Mechanism> unlessBroken(Expected<Mechanism> edited) {
  if (!edited) return edited;
  Diagnostics broken;
  for (Diagnostic& diagnostic : placementOf(*edited).diagnostics) {
    if (diagnostic.severity() == Severity::error) broken.push_back(std::move(diagnostic));
  }
  if (!broken.empty()) return broken;
  return edited;
}

}  // namespace geargraph
