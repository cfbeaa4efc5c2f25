#pragma once

#include "core/foundations/base/expected.h"
#include "core/mechanism/placement/placed_mechanism.h"

namespace geargraph {

/// Brings the two gears of a new mesh together: where one of them has a module already, from another mesh of
/// parallel axes, the head's axis moves along its ray from the tail's to the distance that the teeth need at
/// that module, with all that it carries. Where something pinned (pins.h) or other wheels hold it, the tail's
/// axis moves instead. Rejects teeth-geometry, naming the elements to blame, where neither can move.
///
/// Changes nothing where an axis is not stated (it follows by itself), where no wheel has a module yet or the
/// two have different ones, where another mesh determines the distance of the two axes, and for bevels.
[[nodiscard]] Expected<PlacedMechanism> withMeshSnapped(const PlacedMechanism& before, MeshId mesh);

}  // namespace geargraph
