#pragma once

#include "core/foundations/base/expected.h"
#include "core/mechanism/placement/placed_mechanism.h"

namespace geargraph {

/// Adds copies of a planet with its joint and its meshes, so that there are `total` equally spaced identical
/// planets. If the document states the planet's place, the copies are turned about the axis of the gears that
/// it meshes with. Rejects schema if the link is no planet (one that meshes with gears on one axis only, is
/// carried by another link and carries nothing), and assembly if the assembly condition is violated.
[[nodiscard]] Expected<PlacedMechanism> withPlanets(const PlacedMechanism& before, LinkId planet, int total);

}  // namespace geargraph
