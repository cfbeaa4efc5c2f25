#pragma once

#include <variant>

#include "core/mechanism/model/mechanism.h"
#include "core/presentation/exporters/option_values.h"

namespace geargraph {

/// `--inputs 8,9,11` and `--speed 8=1`: joints by label, speeds in rad/s. The mechanism with these inputs
/// instead of its own. A joint of --inputs keeps its speed in the document, or gets 1 rad/s. --speed alone
/// changes the speeds of existing inputs: the document's, or those chosen automatically.
[[nodiscard]] std::variant<Mechanism, UsageError> withInputOptions(Mechanism mechanism,
                                                                   const OptionValues& given);

}  // namespace geargraph
