#pragma once

#include <QString>

#include "ui/workbench/forces_service.h"

namespace geargraph {

/// Why a picture of these forces is incomplete or empty, and what to do: no loads, no equilibrium, an unknown
/// unit of length, indeterminate forces. Empty if all forces are known.
/// Cost: O(meshes + joints).
[[nodiscard]] QString forcesCaption(const ForcesPtr& forces);

}  // namespace geargraph
