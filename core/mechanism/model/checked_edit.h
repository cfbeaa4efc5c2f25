#pragma once

#include <string_view>

#include "core/foundations/base/expected.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph {

/// The edited mechanism, or the first diagnostic of `checks`, then of limitDiagnostics(), whose JSON pointer
/// begins with `pointer`. The error has no pointer, because there is no file.
[[nodiscard]] Expected<Mechanism> checkedEdit(Mechanism mechanism, std::string_view pointer,
                                              Diagnostics (*checks)(const Mechanism&));

}  // namespace geargraph
