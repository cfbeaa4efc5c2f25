#pragma once

#include "core/mechanism/model/mechanism.h"

namespace geargraph::inline model {

/// Do the names of the axes run a, b, c, ... without gaps, in the order of the joints that use them first, as
/// the paper's? Cost: O(t).
[[nodiscard]] bool doAxisLettersRun(const Mechanism& mechanism);

/// `edited`, an edit of `before`, with letters that run where those of `before` do; names that somebody has
/// chosen stay. Loads that name axes follow. Cost: O(t).
[[nodiscard]] Mechanism withAxisLettersAsBefore(const Mechanism& before, Mechanism edited);

}  // namespace geargraph::inline model
