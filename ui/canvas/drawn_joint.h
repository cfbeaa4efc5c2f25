#pragma once

#include "core/foundations/base/expected.h"
#include "core/mechanism/placement/placed_mechanism.h"

namespace geargraph::inline canvas {

/// A turning joint as somebody draws it. Meshes that were drawn before their joints, and that the joints on
/// distinct axes leave without a carrier, are guessed again as withDrawnMesh() guesses those drawn after
/// them: the axes, and where nobody has changed them, teeth and kind.
///
/// Refuses what withTurningJoint() refuses. Cost: that of placementOf(), and of withDrawnMesh() for each such
/// mesh once the joints are a spanning tree.
[[nodiscard]] Expected<PlacedMechanism> withDrawnJoint(const Mechanism& before, LinkId tail, LinkId head);

}  // namespace geargraph::inline canvas
