#pragma once

#include "core/foundations/base/expected.h"
#include "core/mechanism/placement/placed_mechanism.h"

namespace geargraph::inline fitting {

/// Has the document a geometry to keep, and not too much of it to follow at once?
[[nodiscard]] bool canBeFitted(const Placement& placement);

/// The edited document, unless the edit broke a geometry that was sound, or gave a pinned mesh another
/// module. Cost: its placement, which comes with it.
[[nodiscard]] Expected<PlacedMechanism> unlessBroken(const PlacedMechanism& before,
                                                     Expected<Mechanism> edited);

}  // namespace geargraph::inline fitting
