#pragma once

#include "core/foundations/base/expected.h"
#include "core/mechanism/placement/placed_mechanism.h"

namespace geargraph {

/// Adds a drawn turning joint. For meshes that were drawn before their joints, and that have no carrier with
/// joints on distinct axes, axes are guessed again as by withDrawnMesh(), and so are teeth and kind if the
/// user has not changed them.
///
/// Rejects as withTurningJoint(). Cost: that of placementOf(), and of withDrawnMesh() for each such mesh once
/// the joints are a spanning tree.
[[nodiscard]] Expected<PlacedMechanism> withDrawnJoint(const Mechanism& before, LinkId tail, LinkId head);

}  // namespace geargraph
