#pragma once

#include <map>

#include "core/foundations/base/expected.h"
#include "core/mechanism/geometry_edits/teeth_fit.h"

namespace geargraph {

/// Moves the axes whose places the document states, so that the centre distances of pairs of axes change by
/// `scales`, then updates the stated pitch points. Points that the document leaves open follow by themselves.
///
/// 1. In every train connected by meshes, the first axis nearest the ground stays; so do axes that no new
///    distance affects.
/// 2. An axis with one neighbour keeps its direction from it; with two it goes to the intersection of both
///    distances, on the side where it was; an axis that is only carried by a link that moves, or whose bevels
///    share an apex, moves with it.
/// 3. A bevel's pitch point keeps its apex, its sides and the module of the mesh.
///
/// `pinned`: given places, by axis class. Axes that the user has pinned stay where they are. Rejects
/// teeth-geometry, naming the meshes and what is pinned, where the distances cannot be satisfied.
/// @pre every mesh of `before` has a geometry in `placement`; `edited` is `before` with other teeth or kinds
[[nodiscard]] Expected<Mechanism> fitAxes(const Mechanism& before, const Placement& placement,
                                          Mechanism edited, const std::map<AxisPair, Rational>& scales,
                                          const std::map<int, ExactVector3>& pinned = {});

}  // namespace geargraph
