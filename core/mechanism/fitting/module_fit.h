#pragma once

#include <optional>

#include "core/foundations/base/expected.h"
#include "core/mechanism/placement/placed_mechanism.h"

namespace geargraph::inline fitting {

/// The module of a mesh in the document's unit, 2 r / N: of bevels at their pitch point, the large end.
/// Nothing where the mesh has no geometry in this placement of the mechanism.
[[nodiscard]] std::optional<double> moduleOf(const Mechanism& mechanism, const Placement& placement,
                                             int mesh);

/// Gives a mesh this module, and the meshes of the same wheels and of the same pair of axes with it: axes go
/// apart or together, bevels grow or shrink about their apex. Tooth counts stay, so no ratio changes.
/// Refuses unknown-id, and teeth-geometry for a module that is not positive, and where the train has no
/// geometry to keep or something pinned is in the way.
[[nodiscard]] Expected<PlacedMechanism> withModule(const PlacedMechanism& before, MeshId mesh,
                                                   const Rational& module);

}  // namespace geargraph::inline fitting
