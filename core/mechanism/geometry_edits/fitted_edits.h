#pragma once

#include <span>

#include "core/foundations/base/expected.h"
#include "core/mechanism/placement/placed_mechanism.h"

namespace geargraph {

// Edits that keep the train geometrically consistent: coaxial wheels stay coaxial, the ring follows sun and
// planets, a bevel keeps its apex, identical planets change together. Places and pitch points that the
// document leaves open follow by themselves, stated ones are moved, pinned ones (pins.h) stay. An edit that
// cannot be satisfied is rejected with the elements to blame. Where the document has no consistent geometry
// (its joints form no tree, a mesh contradicts its axes), or more than kMaxFittedMeshes meshes, these are
// the plain edits of edits.h.

constexpr int kMaxFittedMeshes = 500;  ///< with more, fitting is too slow for typing

/// Sets the tooth counts of a mesh, with all consequences (TeethFit). Rejects unknown-id, schema,
/// teeth-geometry and pitch-geometry.
[[nodiscard]] Expected<PlacedMechanism> withTeethFitted(const PlacedMechanism& before, MeshId mesh,
                                                        int tailTeeth, int headTeeth);

/// The tooth counts of a mesh, by position.
struct MeshTeeth {
  MeshOrdinal mesh = 0;
  int tailTeeth = 1;
  int headTeeth = 1;
};

/// Sets the tooth counts of several meshes as they are given: nothing else gets other teeth, so that a whole
/// choice of teeth is one edit. Two axes take the distance of the mesh between them with a pinned module,
/// else of the first external one, at its present module; between two pinned axes the distance stays. Rejects
/// schema (teeth), teeth-geometry, also where a pinned link would get other teeth, and pitch-geometry.
[[nodiscard]] Expected<PlacedMechanism> withAllTeethFitted(const PlacedMechanism& before,
                                                           std::span<const MeshTeeth> teeth);

/// Changes the kind of a mesh. Between external and internal, the axes move to the new distance. Where the
/// document leaves the axes open, a pair becomes bevel together with the meshes that must become bevel too
/// (those between the same axes and those of its wheels); a guessed ring becomes a side gear with as many
/// teeth as the other. Rejects pitch-geometry where stated axes contradict the kind.
[[nodiscard]] Expected<PlacedMechanism> withKindFitted(const PlacedMechanism& before, MeshId mesh,
                                                       MeshKind kind);

/// Moves one wheel of a bevel mesh (`ofTail`: the tail's) to the other side of the apex on its own axis, with
/// its other meshes; the other wheel stays. Rejects unknown-id, and pitch-geometry for a pair that is no
/// bevel.
[[nodiscard]] Expected<PlacedMechanism> withBevelSideFlipped(const PlacedMechanism& before, MeshId mesh,
                                                             bool ofTail);

/// Pins an axis, a link or a mesh, or unpins it (pins.h). Pinning states the present place of an automatic
/// axis, and of both axes of a pinned mesh. Rejects unknown-id.
[[nodiscard]] Expected<PlacedMechanism> withPinned(const PlacedMechanism& before, const ElementId& element,
                                                   bool pinned);
/// withPinned() for several elements, all or none.
[[nodiscard]] Expected<PlacedMechanism> withAllPinned(const PlacedMechanism& before,
                                                      std::span<const ElementId> elements, bool pinned);

}  // namespace geargraph
