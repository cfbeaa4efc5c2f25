#pragma once

#include <functional>
#include <vector>

#include "core/mechanism/fitting/wheel_map.h"

namespace geargraph::inline fitting {

/// Meshes that have one module with those that `starts` names, step by step: of the same wheels, and between
/// parallel axes of the same pair of axes. Bevels and meshes of parallel axes do not reach each other.
[[nodiscard]] std::vector<int> meshesOfOneModule(const Mechanism& mechanism, const Placement& placement,
                                                 const std::function<bool(int mesh)>& starts);

}  // namespace geargraph::inline fitting
