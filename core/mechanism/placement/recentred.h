#pragma once

#include <optional>

#include "core/mechanism/placement/placement.h"

namespace geargraph::inline placement {

/// A placement about another origin than the document's.
struct Recentred {
  Placement placement;
  Vector3 origin;  ///< of the placement, in the document's coordinates
};

/// The placement with the origin moved to a point of its own, if it is so far from the document's origin that
/// doubles there lose digits which its gears need; else std::nullopt. What does not depend on the place of a
/// train is computed from it. Cost: O(n + c), fractions only if something is returned.
/// @pre the placement is the mechanism's
[[nodiscard]] std::optional<Recentred> recentred(const Mechanism& mechanism, const Placement& placement);

}  // namespace geargraph::inline placement
