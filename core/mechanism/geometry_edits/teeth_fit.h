#pragma once

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "core/foundations/base/expected.h"
#include "core/mechanism/geometry_edits/wheel_map.h"

namespace geargraph {

/// Two axis classes with meshes of parallel axes between them, the smaller first: one centre distance.
using AxisPair = std::pair<AxisGroupOrdinal, AxisGroupOrdinal>;

/// The tooth counts and centre distances after a change.
struct TeethFit {
  std::vector<int> teeth;               ///< by end (wheel_map.h)
  std::map<AxisPair, Rational> scales;  ///< new centre distance over the old one; other pairs keep theirs
};

/// A change of the teeth of one mesh, or of its kind.
struct MeshChange {
  MeshOrdinal mesh = 0;
  int tailTeeth = 1;
  int headTeeth = 1;
  MeshKind kind = kUsualKind;
};

/// What follows from the change, with the module kept and coaxial axes kept coaxial:
///
/// 1. The wheel's other meshes get its new teeth, and so do the identical planets of its set.
/// 2. A pair of axes takes the centre distance that its changed mesh needs at its present module, one with a
///    pinned module first, then an external one.
/// 3. Other meshes of that pair keep their module: the wheel whose teeth are not determined yet is adapted,
/// in an internal pair the ring. Where no whole count fits they keep their teeth, and their module changes
/// (as in Ferguson's paradox).
/// 4. Repeat for the pairs of axes of the wheels changed in step 3.
///
/// Pins: a wheel of a pinned link keeps its teeth, so that in step 3 the other wheel is adapted, or the one
/// that both meshes share; between two pinned axes the distance stays, and the other wheel of the changed
/// mesh is adapted.
///
/// Rejects teeth-geometry where a wheel would need fewer than 4 teeth, or an internal pair equal counts, or
/// where only pinned elements could be adapted.
/// @pre every mesh has a geometry in the placement
[[nodiscard]] Expected<TeethFit> fitTeeth(const Mechanism& mechanism, const Placement& placement,
                                          const WheelMap& wheels, const MeshChange& change);

[[nodiscard]] AxisPair axisPairOf(const MeshGeometry& geometry);

}  // namespace geargraph
