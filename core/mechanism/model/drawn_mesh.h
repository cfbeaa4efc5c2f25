#pragma once

#include "core/foundations/base/expected.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph::inline model {

/// A gear mesh as somebody draws it between two links, with what the drawing leaves open guessed so that the
/// train makes sense at once. A guess never changes what the document states: axes that are placed stay.
///
/// 1. Axes. The two gears need a link that carries both their axes: the path of turning joints from one to
///    the other must change its axis once. Where it changes oftener, the two joints by which it leaves the
///    same link turn about one axis, if that does it: sun and carrier on the ground, motor and arm on a
///    carrier. Letters of axes go on running without gaps (axis_letters.h).
/// 2. Teeth. A link that meshes on this axis already, under the same carrier, has its wheel.
/// 3. Kind. Under a carrier that turns, the second gear that a planet meshes with, on the axis of the first
///    one, is the ring round it, internal, of as many teeth as sun and twice the planet; where the first one
///    is a bevel gear, it is one like it.
///
/// Refuses what withGearMesh() refuses. Cost: O(n + t + c).
[[nodiscard]] Expected<Mechanism> withDrawnMesh(Mechanism mechanism, LinkId tail, LinkId head);

}  // namespace geargraph::inline model
