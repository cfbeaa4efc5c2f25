#pragma once

#include "core/foundations/base/diagnostic.h"
#include "core/machine/teeth/gear_spec.h"

namespace geargraph {

/// Why no gear can be made from the spec (`teeth-geometry`): too few teeth for the rack, a bore that leaves
/// no body, ...
[[nodiscard]] Diagnostics specDiagnostics(const GearSpec& spec);

}  // namespace geargraph
