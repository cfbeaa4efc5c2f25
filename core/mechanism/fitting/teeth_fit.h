#pragma once

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "core/foundations/base/expected.h"
#include "core/mechanism/fitting/wheel_map.h"

namespace geargraph::inline fitting {

/// Two axis classes with meshes of parallel axes between them, the smaller first: one centre distance.
using AxisPair = std::pair<int, int>;

/// How tooth counts and centre distances follow from a change.
struct TeethFit {
  std::vector<int> teeth;               ///< by end (wheel_map.h)
  std::map<AxisPair, Rational> scales;  ///< new centre distance over the old one; pairs not named keep theirs
};

/// A change of the teeth of one mesh, or of its kind.
struct MeshChange {
  int mesh = 0;
  int tailTeeth = 1;
  int headTeeth = 1;
  MeshKind kind = MeshKind::external;
};

/// What follows from the change, module and axes kept coaxial:
///
/// 1. The wheel's other meshes have its new teeth, and so have its twins, the other planets.
/// 2. A pair of axes takes the distance that its changed mesh asks for at the module it has, one with a
///    pinned module first, then an external one.
/// 3. Other meshes of that pair keep their module: of their wheels the one that is not given yet follows, of
/// an
///    internal pair the ring. Where no whole count fits they keep their teeth, and their module follows (as
///    in Ferguson's paradox).
/// 4. So on, with the pairs that wheels changed in step 3 belong to.
///
/// Pins: a wheel of a pinned link keeps its teeth, so that in step 3 the other wheel follows, or the one that
/// both meshes share; between two pinned axes the distance stays, and the other wheel of the changed mesh
/// follows.
///
/// Refuses teeth-geometry where a wheel would need fewer than 4 teeth, or an internal pair equal counts, or
/// where only pinned things could follow.
/// @pre every mesh has a geometry in the placement
[[nodiscard]] Expected<TeethFit> fitTeeth(const Mechanism& mechanism, const Placement& placement,
                                          const WheelMap& wheels, const MeshChange& change);

[[nodiscard]] AxisPair axisPairOf(const MeshGeometry& geometry);

}  // namespace geargraph::inline fitting
