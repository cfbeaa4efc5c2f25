#pragma once

#include <map>

#include "core/foundations/base/expected.h"
#include "core/mechanism/fitting/teeth_fit.h"

namespace geargraph::inline fitting {

/// Moves the axes whose places the document states, so that pairs of axes get the distances that `scales`
/// says, then renews the pitch points that it states. Points it leaves open follow by themselves.
///
/// 1. Of every train that hangs together by meshes, the first axis nearest the ground stays; so do axes
///    that no new distance reaches.
/// 2. An axis with one neighbour keeps its direction from it; with two it goes where both distances meet,
///    on the side where it was; an axis that only hangs on a link that moves, or whose bevels share an apex,
///    goes along.
/// 3. A bevel's pitch point keeps its apex, its sides and the module of the mesh.
///
/// `pinned`, by class: places that are given. Axes that the user has pinned stay where they are. Refuses
/// teeth-geometry, with the meshes and what is pinned, where distances do not meet.
/// @pre every mesh of `before` has a geometry in `placement`; `edited` is `before` with other teeth or kinds
[[nodiscard]] Expected<Mechanism> fitAxes(const Mechanism& before, const Placement& placement,
                                          Mechanism edited, const std::map<AxisPair, Rational>& scales,
                                          const std::map<int, ExactVector3>& pinned = {});

}  // namespace geargraph::inline fitting
