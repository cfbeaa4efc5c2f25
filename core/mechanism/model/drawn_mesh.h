#pragma once

#include "core/foundations/base/expected.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph {

/// Adds a gear mesh drawn between two links, and guesses what the drawing leaves open so that the train is
/// valid at once. A guess never changes what the document states: placed axes stay.
///
/// 1. Axes. The two gears need a link that carries both their axes: the path of turning joints from one to
///    the other must change its axis once. Where it changes more often, the two joints of the path at one
///    link are put on one axis if that suffices: sun and carrier on the ground, motor and arm on a carrier.
///    Axis letters stay without gaps (axis_letters.h).
/// 2. Teeth. A link that already meshes on this axis with the same carrier uses that wheel.
/// 3. Kind. On a moving carrier, the second gear that a planet meshes with on the axis of the first one is
///    taken as an internal ring gear with the teeth of the sun plus twice those of the planet; where the
///    first one is a bevel gear, as an equal bevel gear.
///
/// Rejects as withGearMesh(). Cost: O(n + t + c).
[[nodiscard]] Expected<Mechanism> withDrawnMesh(Mechanism mechanism, LinkId tail, LinkId head);

}  // namespace geargraph
