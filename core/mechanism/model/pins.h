#pragma once

#include "core/foundations/base/expected.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph {

// What the user has pinned stays as it is while other things change: an axis keeps its place, the gears of a
// link keep their teeth, a mesh its module. No number of the analysis depends on it.

[[nodiscard]] inline bool isPinned(const Axis& axis) {
  return axis.pinned;
}
[[nodiscard]] inline bool isPinned(const Link& link) {
  return link.pinned;
}
[[nodiscard]] inline bool isPinned(const GearMesh& mesh) {
  return mesh.pinned;
}

/// Pins an axis, a link or a mesh, or unpins it. Rejects unknown-id.
[[nodiscard]] Expected<Mechanism> withPinMark(Mechanism mechanism, const ElementId& element, bool pinned);

}  // namespace geargraph
