#pragma once

#include <optional>

#include "core/foundations/base/expected.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph {

// Edits of mass, density and gravity, for dynamics: pure functions, as in edits.h.

/// Sets the stated mass of a moving link; none: it is computed from the link's solids. Rejects unknown-id,
/// and schema for what massProblem() finds and for numbers beyond the limits of the format.
[[nodiscard]] Expected<Mechanism> withLinkMass(Mechanism mechanism, LinkId link,
                                               std::optional<LinkMass> mass);
/// The density of all solids, kg/m³; none: kSteelDensity. Rejects schema unless it is above 0.
[[nodiscard]] Expected<Mechanism> withDensity(Mechanism mechanism, std::optional<Number> density);
/// The acceleration of free fall, m/s², base frame; none for no gravity. Rejects schema for numbers beyond
/// the limits of the format.
[[nodiscard]] Expected<Mechanism> withGravity(Mechanism mechanism, std::optional<NumberTriple> gravity);

/// What wellFormedDiagnostics() finds about masses, density and gravity: schema. Cost: O(n).
[[nodiscard]] Diagnostics massDiagnostics(const Mechanism& mechanism);

}  // namespace geargraph
