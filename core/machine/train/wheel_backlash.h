#pragma once

#include <optional>

#include "core/foundations/base/rational.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph {

/// The backlash of a pair of wheels like this one, in modules: the wheel's own, else the document's, else
/// 0.04. Its teeth are thinner by half of it on the pitch circle. `wheel`: none for one that is not named.
[[nodiscard]] Rational backlashOf(const Mechanism& mechanism, const std::optional<WheelId>& wheel);

}  // namespace geargraph
