#pragma once

#include <string>
#include <vector>

#include "core/mechanism/model/mechanism.h"

namespace geargraph {

/// `count` texts: the smallest whole numbers that no link, turning joint or mesh has as its id, so that the
/// three kinds cannot be confused. Cost: O(n + t + c + count).
[[nodiscard]] std::vector<std::string> freshIds(const Mechanism& mechanism, int count);
[[nodiscard]] std::string freshId(const Mechanism& mechanism);

/// The first ids of "a", "b", ... "z", "a1", ... that no axis has: the levels of the T-T graph are lower-case
/// letters.
[[nodiscard]] std::vector<AxisId> freshAxisIds(const Mechanism& mechanism, int count);

}  // namespace geargraph
