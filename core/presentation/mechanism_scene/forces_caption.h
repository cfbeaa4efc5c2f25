#pragma once

#include <string>

#include "core/theory/statics/statics_report.h"

namespace geargraph {

/// Why some or all forces of a report are missing in a picture, and what to do about it: no loads, no
/// equilibrium, an unknown unit of length, indeterminate load sharing; or that load sharing is assumed to be
/// by equal stiffness. Empty if all forces are determined without that assumption. In the current language.
/// Cost: O(meshes + joints). @pre the report is the mechanism's, or null
[[nodiscard]] std::string forcesCaption(const Mechanism& mechanism, const StaticsReport* report);

/// The loads: "Loads: joint 7: 10 N m, link 3: 20 N." Empty without loads.
[[nodiscard]] std::string loadsCaption(const Mechanism& mechanism, const StaticsReport* report);

}  // namespace geargraph
