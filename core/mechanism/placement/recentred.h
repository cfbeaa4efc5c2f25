#pragma once

#include <optional>

#include "core/mechanism/placement/placement.h"

namespace geargraph {

/// A placement relative to another origin than the document's.
struct Recentred {
  Placement placement;
  Vector3 origin;  ///< of the placement, in the document's coordinates
};

/// The placement with the origin moved to a point of its own, if the train is so far from the document's
/// origin that doubles are not precise enough for its gears; else std::nullopt. Results that do not depend on
/// the place of the train are computed from it. Cost: O(n + c), fractions only if something is returned.
/// @pre the placement is the mechanism's
[[nodiscard]] std::optional<Recentred> recentred(const Mechanism& mechanism, const Placement& placement);

}  // namespace geargraph
