#pragma once

#include "core/foundations/base/expected.h"
#include "core/mechanism/placement/placed_mechanism.h"

namespace geargraph::inline synthesis {

/// As many equal planets as wanted, evenly spread: copies of a drawn one with its joint and its meshes. Where
/// the document states the planet's place, the copies are turned about the axis of what it meshes with.
/// Refuses schema where the link is no planet (its meshes are with one axis, on a link that carries it, and
/// it carries nothing), and assembly where so many do not go in.
[[nodiscard]] Expected<PlacedMechanism> withPlanets(const PlacedMechanism& before, LinkId planet, int total);

}  // namespace geargraph::inline synthesis
