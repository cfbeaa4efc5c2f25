#pragma once

#include "core/machine/solids/solid.h"
#include "core/machine/teeth/gear_spec.h"

namespace geargraph {

/// With more teeth than this, a tooth is smaller than a pixel whenever the whole wheel is in view.
constexpr int kMaxShownTeeth = 5'000;

/// The gear as a solid of revolution, in its own frame: its body and, in place of teeth, the volume up to its
/// pitch cylinder (bevels: tip cone; rings: from the pitch cylinder outwards). `tolerance` in modules.
/// Cost: O(sqrt(teeth / tolerance)).
/// @pre specDiagnostics() is empty
[[nodiscard]] Solid toothlessGear(const GearSpec& spec, double tolerance);

}  // namespace geargraph
