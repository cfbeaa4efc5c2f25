#pragma once

#include <variant>

#include "app/cli/arguments.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph::cli {

/// `--inputs 8,9,11` and `--speed 8=1`: joints by label, speeds in rad/s. The mechanism with these inputs in
/// place of its own. A joint that --inputs names keeps the speed that the document gives it, else it turns at
/// 1; --speed alone changes inputs that are there, those of the document or those that were chosen for it.
[[nodiscard]] std::variant<Mechanism, UsageError> withInputOptions(Mechanism mechanism,
                                                                   const Arguments& arguments);

}  // namespace geargraph::cli
