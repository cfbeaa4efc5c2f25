#pragma once

#include <span>

#include "core/foundations/base/expected.h"
#include "core/mechanism/placement/placed_mechanism.h"

namespace geargraph::inline fitting {

// Edits after which everything still fits: coaxial wheels stay coaxial, the ring follows sun and planets, a
// bevel keeps its apex, twins of a planet follow it. Places and pitch points that the document leaves open
// follow by themselves, stated ones are moved, pinned ones (pins.h) stay. What cannot be satisfied is refused
// with the culprits. Where
// the document has no geometry to keep (its joints are no tree, a mesh contradicts its axes), or more than
// kMostFittedMeshes, these are the plain edits of edits.h.

constexpr int kMostFittedMeshes = 500;  ///< beyond, following would not keep up with typing

/// Other tooth counts for a mesh, with all that follows (TeethFit). Refuses unknown-id, schema,
/// teeth-geometry and pitch-geometry.
[[nodiscard]] Expected<PlacedMechanism> withTeethFitted(const PlacedMechanism& before, MeshId mesh,
                                                        int tailTeeth, int headTeeth);

/// An external pair becomes internal or the other way round; the axes move to the new distance. Where the
/// document leaves the axes open, a pair becomes a bevel pair together with all that must be bevels with it,
/// those between the same axes and those on its wheels; what was taken for a ring becomes a side gear as
/// large as the other. Refuses pitch-geometry where axes that are stated contradict the kind.
[[nodiscard]] Expected<PlacedMechanism> withKindFitted(const PlacedMechanism& before, MeshId mesh,
                                                       MeshKind kind);

/// The wheel of a bevel mesh goes to the other side of the apex, on its own axis; its other meshes go along.
/// The other wheel stays. Refuses unknown-id, and pitch-geometry for a pair that is no bevel.
[[nodiscard]] Expected<PlacedMechanism> withBevelSideFlipped(const PlacedMechanism& before, MeshId mesh,
                                                             bool ofTail);

/// Pins an axis, a link or a mesh, or lets it go (pins.h). An axis that the program has placed so far is
/// stated where it lies, and so are both axes of a mesh. Refuses unknown-id.
[[nodiscard]] Expected<PlacedMechanism> withPinned(const PlacedMechanism& before, const ElementId& element,
                                                   bool pinned);
/// All of these.
[[nodiscard]] Expected<PlacedMechanism> withAllPinned(const PlacedMechanism& before,
                                                      std::span<const ElementId> elements, bool pinned);

}  // namespace geargraph::inline fitting
