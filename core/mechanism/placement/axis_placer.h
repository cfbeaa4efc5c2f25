#pragma once

#include <optional>
#include <vector>

#include "core/mechanism/placement/axis_line.h"
#include "core/mechanism/placement/mesh_word.h"

namespace geargraph {

/// The module (pitch diameter / teeth) of trains whose document gives no size.
constexpr int kDefaultModule = 2;

/// The module of the pitch circles that a mesh states, of parallel axes in the transverse plane: m_n / cos
/// beta, a fraction near it where it is irrational. std::nullopt where it states none.
[[nodiscard]] std::optional<Rational> statedModule(const GearMesh& mesh);

struct PlacedAxes {
  ByAxis<AxisLine> lines;
  std::vector<ExactLine> chosen;  ///< the automatic lines in fractions
  Rational module = kDefaultModule;
  ByMesh<int> bevelSizes;  ///< the module of a derived bevel pair, in halves of `module`;
                           ///< empty: of the usual size
};

/// Places the axes that the document leaves open.
///
/// 1. Axes with point and direction stay. The centre distance of a mesh between two of them that are parallel
///    gives the module; else kDefaultModule.
/// 2. From placed axes outward, along meshes: an axis of an external or internal mesh is parallel to its
///    neighbour at the centre distance of the teeth; several around one neighbour on one carrier are equally
///    spaced; an axis between two placed ones is at the intersection of both distances, if there is one.
/// 3. An axis of a bevel mesh intersects its neighbour at right angles (along y for a neighbour along z or x,
///    along z for one along y), where the wheels do not interfere (bevel_arranger.h); several on one carrier
///    are spread around the same apex.
/// 4. An axis of a pair for skew axes crosses its neighbour at right angles, at the distance of the teeth.
/// 5. Axes that no mesh connects to these start a new group beside them, along z.
///
/// `given`: givenLines(), which marks the open axes. `words`: by mesh, none for a mesh without a carrier;
/// empty without a tree.
[[nodiscard]] PlacedAxes placedAxes(const Mechanism& mechanism, ByAxis<AxisLine> given, const JointTree* tree,
                                    const AxisGroups& classes,
                                    const ByMesh<std::optional<MeshAxisPath>>& words);

}  // namespace geargraph
