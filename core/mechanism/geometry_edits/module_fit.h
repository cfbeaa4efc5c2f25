#pragma once

#include <optional>

#include "core/foundations/base/expected.h"
#include "core/mechanism/placement/placed_mechanism.h"

namespace geargraph {

/// The module of a mesh in the document's unit, 2 r / N: for bevels at the pitch point, which is at the large
/// end. std::nullopt if the mesh has no geometry in this placement of the mechanism.
[[nodiscard]] std::optional<double> moduleOf(const Mechanism& mechanism, const Placement& placement,
                                             MeshOrdinal mesh);

/// Sets the module of a mesh, and of the meshes of the same wheels and of the same pair of axes: centre
/// distances change, bevels are scaled about their apex. Tooth counts stay, so no ratio changes. Rejects
/// unknown-id, and teeth-geometry for a module that is not positive, where the train's geometry is
/// inconsistent, or where something pinned prevents it.
[[nodiscard]] Expected<PlacedMechanism> withModule(const PlacedMechanism& before, MeshId mesh,
                                                   const Rational& module);

}  // namespace geargraph
