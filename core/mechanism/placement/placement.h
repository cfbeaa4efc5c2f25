#pragma once

#include <optional>
#include <vector>

#include "core/mechanism/placement/axis_placer.h"
#include "core/mechanism/placement/mesh_geometry.h"

namespace geargraph {

/// The reference geometry of a mechanism: the line of every axis, and for every mesh its carrier, its pitch
/// point and the sign and radii that follow. What the document leaves open is chosen here, so that a digraph
/// with tooth counts is enough for an analysis and a 3D view.
struct Placement {
  std::optional<JointTree> tree;      ///< none if the turning joints are no spanning tree: no meshes then
  std::optional<AxisGroups> classes;  ///< with the tree
  ByAxis<AxisLine> axes;
  std::vector<ExactLine> chosen;               ///< of the automatic axes, in fractions
  ByMesh<std::optional<MeshGeometry>> meshes;  ///< none for a mesh with a diagnostic
  Rational module = kDefaultModule;            ///< that automatic axes and bevel points were placed with
  Diagnostics diagnostics;

  /// The line of an axis class. @pre there is a tree
  [[nodiscard]] const AxisLine& lineOfClass(AxisGroupOrdinal axisGroup) const {
    return axes[classes->classes[axisGroup].axis];
  }
};

/// Places all axes and meshes. Diagnostics: split-axis, merged-axes, coaxial-mesh, no-transfer-vertex,
/// pitch-point-on-axis, pitch-geometry, teeth-geometry. Disconnected links and loops of turning joints are
/// reported by treeDiagnostics().
///
/// Pitch points that the document leaves open: between parallel axes from the teeth (internal if `kind` says
/// so, else external), in the plane of the axis point nearer the ground; between intersecting axes at the
/// document's module, on the half axes where the bearings' offsets are, by default on the positive half of
/// the outer axis and the negative half of the inner one, and on both halves for the wheels of two links that
/// mesh with the same wheel (the side gears of a differential). Pairs about one apex are nested.
///
/// Cost: O(n + t + c) and the axis classes on each mesh's path.
/// @pre the mechanism is well formed
[[nodiscard]] Placement placementOf(const Mechanism& mechanism);
/// The same for a mechanism whose tree is known; std::nullopt: it has none.
[[nodiscard]] Placement placementOf(const Mechanism& mechanism, std::optional<JointTree> tree);

/// The line of an axis in fractions: as chosen, or as written in the document.
/// @pre the placement is the mechanism's
[[nodiscard]] ExactLine exactLine(const Mechanism& mechanism, const Placement& placement, AxisOrdinal axis);

/// The line of a class in fractions. @pre the placement is the mechanism's and has a tree
[[nodiscard]] ExactLine exactLineOfClass(const Mechanism& mechanism, const Placement& placement,
                                         AxisGroupOrdinal axisGroup);

/// The pitch point of a mesh in fractions, if it is rational: written in the document, or derived without an
/// irrational root; else std::nullopt.
/// @pre the mesh has a geometry in this placement of the mechanism
[[nodiscard]] std::optional<ExactVector3> exactPitchPoint(const Mechanism& mechanism,
                                                          const Placement& placement, MeshOrdinal mesh);

}  // namespace geargraph
