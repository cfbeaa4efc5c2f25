#pragma once

#include <string_view>

#include "core/foundations/base/expected.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph::inline model {

/// The edited mechanism, or the first finding of `checks`, then of the limits, at a member whose pointer
/// begins so. A refusal has no pointer: the file it would be in does not exist.
[[nodiscard]] Expected<Mechanism> checkedEdit(Mechanism mechanism, std::string_view pointer,
                                              Diagnostics (*checks)(const Mechanism&));

}  // namespace geargraph::inline model
