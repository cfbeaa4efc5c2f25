#pragma once

#include <string>

#include "core/theory/statics/statics_report.h"

namespace geargraph::inline train_stage {

/// Why a picture of the forces of a report lacks some, or has none, and what to do: no loads, no equilibrium,
/// a unit of length that is not known, loads that are shared in unknown parts; that the parts are those of
/// equal stiffness, an assumption. Empty where all forces are known without it. In the language in use.
/// Cost: O(meshes + joints). @pre the report is the mechanism's, or null
[[nodiscard]] std::string forcesCaption(const Mechanism& mechanism, const StaticsReport* report);

/// The loads that act: "Loads: joint 7: 10 N m, link 3: 20 N." Empty without.
[[nodiscard]] std::string loadsCaption(const Mechanism& mechanism, const StaticsReport* report);

}  // namespace geargraph::inline train_stage
