#pragma once

#include "core/foundations/base/expected.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph {

/// Are the axes named a, b, c, ... without gaps, in the order of the joints that use them first, as in the
/// paper? Cost: O(t).
[[nodiscard]] bool doAxisLettersRun(const Mechanism& mechanism);

/// The document `edited` (from `before`) with its axes renamed without gaps if those of `before` were; names
/// chosen by the user stay. Loads that name axes are updated. An error is passed on. Cost: O(t).
[[nodiscard]] Expected<Mechanism> withAxisLettersAsBefore(const Mechanism& before,
                                                          Expected<Mechanism> edited);

}  // namespace geargraph
