#pragma once

#include <string_view>

#include "core/base/expected.h"
#include "core/mechanism/mechanism.h"

namespace geargraph {

// What the user has pinned stays as it is while other things change: an axis keeps its place, the gears of a
// link keep their teeth, a mesh its module. In the file it is a member `"pinned": true` of the axis, the link
// or the mesh; programs that do not know it keep it and lose nothing, for no number of the analysis depends
// on it.

constexpr std::string_view kPinned = "pinned";

[[nodiscard]] bool isPinned(const Axis& axis);
[[nodiscard]] bool isPinned(const Link& link);
[[nodiscard]] bool isPinned(const GearMesh& mesh);

/// The mark on an axis, a link or a mesh, set or taken away. Refuses unknown-id.
[[nodiscard]] Expected<Mechanism> withPinMark(Mechanism mechanism, const ElementId& element, bool pinned);

}  // namespace geargraph
