#pragma once

#include <functional>
#include <vector>

#include "core/mechanism/geometry_edits/wheel_map.h"

namespace geargraph {

/// The meshes that must have the same module as those for which `starts` is true, transitively: meshes of the
/// same wheel, and meshes between the same pair of parallel axes. Bevels and meshes of parallel axes do not
/// affect each other.
[[nodiscard]] std::vector<int> meshesOfOneModule(const Mechanism& mechanism, const Placement& placement,
                                                 const std::function<bool(MeshOrdinal mesh)>& starts);

}  // namespace geargraph
