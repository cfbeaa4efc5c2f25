#pragma once

#include <optional>

#include "core/foundations/base/expected.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph::inline model {

// Edits of what dynamics needs beside the geometry: pure functions, as in edits.h.

/// The stated mass of a moving link; none leaves it to the link's solids. Refuses unknown-id, and schema for
/// what massProblem() finds and for numbers beyond the limits of the format.
[[nodiscard]] Expected<Mechanism> withLinkMass(Mechanism mechanism, LinkId link,
                                               std::optional<LinkMass> mass);
/// The density of all solids, kg/m³; none is that of steel. Refuses schema unless it is above 0.
[[nodiscard]] Expected<Mechanism> withDensity(Mechanism mechanism, std::optional<Number> density);
/// The acceleration of free fall, m/s², base frame; none for no gravity. Refuses schema for numbers beyond
/// the limits of the format.
[[nodiscard]] Expected<Mechanism> withGravity(Mechanism mechanism, std::optional<NumberTriple> gravity);

/// What wellFormedDiagnostics() finds about masses, density and gravity: schema. Cost: O(n).
[[nodiscard]] Diagnostics massDiagnostics(const Mechanism& mechanism);

}  // namespace geargraph::inline model
