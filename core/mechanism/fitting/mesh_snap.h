#pragma once

#include "core/foundations/base/expected.h"
#include "core/mechanism/placement/placed_mechanism.h"

namespace geargraph::inline fitting {

/// Brings the two gears of a new mesh together: where one of them has a module already, from another mesh of
/// parallel axes, the head's axis goes to the distance that the teeth ask for at that module, on its ray from
/// the tail's, with all that hangs on it. Where something pinned (pins.h) or other wheels hold it, the tail's
/// axis goes instead. Refuses teeth-geometry, with the culprits, where neither can.
///
/// The document stays as it is where an axis is not stated (it follows by itself), where no wheel has a
/// module yet or both have different ones, where another mesh holds the two axes, and for bevels.
[[nodiscard]] Expected<PlacedMechanism> withMeshSnapped(const PlacedMechanism& before, MeshId mesh);

}  // namespace geargraph::inline fitting
