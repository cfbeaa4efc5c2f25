#pragma once

#include "core/foundations/base/expected.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph::inline model {

/// Do the names of the axes run a, b, c, ... without gaps, in the order of the joints that use them first, as
/// the paper's? Cost: O(t).
[[nodiscard]] bool doAxisLettersRun(const Mechanism& mechanism);

/// `edited`, an edit of `before`, with letters that run where those of `before` do; chosen names stay. Loads
/// that name axes follow. A refused edit stays refused. Cost: O(t).
[[nodiscard]] Expected<Mechanism> withAxisLettersAsBefore(const Mechanism& before,
                                                          Expected<Mechanism> edited);

}  // namespace geargraph::inline model
