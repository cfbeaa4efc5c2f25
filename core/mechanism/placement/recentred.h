#pragma once

#include <optional>

#include "core/mechanism/placement/placement.h"

namespace geargraph::inline placement {

/// The placement with the origin moved to a point of its own, where it is so far from the document's origin
/// that doubles there lose digits which its gears need; else nothing. What does not depend on the place of a
/// train is computed from it. Cost: O(n + c), fractions only where something is returned.
/// @pre the placement is the mechanism's
[[nodiscard]] std::optional<Placement> recentred(const Mechanism& mechanism, const Placement& placement);

}  // namespace geargraph::inline placement
