#pragma once

#include <vector>

#include "core/base/expected.h"
#include "core/mechanism/mechanism.h"

namespace geargraph {

// Edits after which everything still fits: coaxial wheels stay coaxial, the ring follows sun and planets, a
// bevel keeps its apex, twins of a planet follow it. Places and pitch points that the document leaves open
// follow by themselves, stated ones are moved. What cannot be satisfied is refused with the culprits. Where
// the document has no geometry to keep (its joints are no tree, a mesh contradicts its axes), or more than
// kMostFittedMeshes, these are the plain edits of edits.h.

constexpr int kMostFittedMeshes = 500;  ///< beyond, following would not keep up with typing

/// Other tooth counts for a mesh, with all that follows (TeethFit). Refuses unknown-id, schema,
/// teeth-geometry and pitch-geometry.
[[nodiscard]] Expected<Mechanism> withTeethFitted(Mechanism mechanism, MeshId mesh, int tailTeeth,
                                                  int headTeeth);

/// An external pair becomes internal or the other way round; the axes move to the new distance. A bevel pair
/// has no other kind: pitch-geometry.
[[nodiscard]] Expected<Mechanism> withKindFitted(Mechanism mechanism, MeshId mesh, MeshKind kind);

/// The axis goes to a place, and the module of the wheels that hold it follows, with all that they mesh.
[[nodiscard]] Expected<Mechanism> withAxisMoved(Mechanism mechanism, AxisId axis, const NumberTriple& point);

/// Tooth counts that bring an axis near a place with the module as it is.
struct TeethOffer {
  MeshId mesh;
  int tailTeeth = 1;
  int headTeeth = 1;
  double distance = 0;  ///< the centre distance they make
};

/// The nearest counts for a new distance from the axis that it meshes with, the wheel on the moved axis
/// changed first, the nearest first, `most` at most. Empty where the axis has no mesh of parallel axes.
[[nodiscard]] std::vector<TeethOffer> teethNear(const Mechanism& mechanism, AxisId axis,
                                                const NumberTriple& point, std::size_t most = 4);

}  // namespace geargraph
