#pragma once

#include "core/mechanism/placement/placement.h"

namespace geargraph::inline fitting {

/// The axis that an axis class bears the name of.
[[nodiscard]] const Axis& axisOfClass(const Mechanism& mechanism, const Placement& placement, int axisClass);

/// teeth-geometry: a mesh cannot follow, because its gears or axes that could are pinned. Names them.
[[nodiscard]] Diagnostic pinRefusal(const Mechanism& mechanism, const Placement& placement, int mesh);
/// teeth-geometry: the mesh's module is pinned, and would be another one.
[[nodiscard]] Diagnostic modulePinRefusal(const Mechanism& mechanism, int mesh);
/// The axis is pinned where it is.
[[nodiscard]] Diagnostic pinRefusal(const Axis& axis);

}  // namespace geargraph::inline fitting
