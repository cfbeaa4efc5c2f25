#pragma once

#include <QString>

#include "ui/statics/forces_service.h"

namespace geargraph::inline forces {

/// Why a picture of these forces lacks some, or has none, and what to do: no loads, no equilibrium, a unit of
/// length that is not known, loads that are shared in unknown parts. Empty where all forces are known.
/// Cost: O(meshes + joints).
[[nodiscard]] QString forcesCaption(const ForcesPtr& forces);

}  // namespace geargraph::inline forces
