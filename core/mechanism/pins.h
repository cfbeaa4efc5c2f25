#pragma once

#include <string_view>

#include "core/base/expected.h"
#include "core/mechanism/mechanism.h"

namespace geargraph {

// What the user has pinned stays as it is while other things change: an axis keeps its place, the gears of a
// link keep their teeth. In the file it is a member `"pinned": true` of the axis or the link; programs that
// do not know it keep it and lose nothing, for no number of the analysis depends on it.

constexpr std::string_view kPinned = "pinned";

[[nodiscard]] bool isPinned(const Axis& axis);
[[nodiscard]] bool isPinned(const Link& link);

/// The mark on an axis or a link, set or taken away. Refuses unknown-id.
[[nodiscard]] Expected<Mechanism> withPinMark(Mechanism mechanism, const ElementId& element, bool pinned);

}  // namespace geargraph
