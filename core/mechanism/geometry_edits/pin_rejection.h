#pragma once

#include "core/mechanism/placement/placement.h"

namespace geargraph {

/// The axis that gives an axis class its name.
[[nodiscard]] const Axis& axisOfClass(const Mechanism& mechanism, const Placement& placement,
                                      AxisGroupOrdinal axisGroup);

/// teeth-geometry: a mesh cannot be fitted, because the gears or axes that would have to change are pinned.
/// Names them.
[[nodiscard]] Diagnostic pinRejection(const Mechanism& mechanism, const Placement& placement,
                                      MeshOrdinal mesh);
/// teeth-geometry: the mesh's module is pinned and would change.
[[nodiscard]] Diagnostic modulePinRejection(const Mechanism& mechanism, MeshOrdinal mesh);
/// teeth-geometry: the axis is pinned and would move.
[[nodiscard]] Diagnostic pinRejection(const Axis& axis);

}  // namespace geargraph
