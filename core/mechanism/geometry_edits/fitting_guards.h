#pragma once

#include "core/foundations/base/expected.h"
#include "core/mechanism/placement/placed_mechanism.h"

namespace geargraph {

/// Is the document's geometry consistent, and small enough (kMaxFittedMeshes) to be fitted?
[[nodiscard]] bool canBeFitted(const Placement& placement);

/// Returns the edited document with its placement; an error if the edit made a consistent geometry
/// inconsistent, or changed the module of a pinned mesh. Cost: the placement.
[[nodiscard]] Expected<PlacedMechanism> unlessBroken(const PlacedMechanism& before,
                                                     Expected<Mechanism> edited);

}  // namespace geargraph
