#pragma once

#include <variant>

#include "core/foundations/base/translation.h"
#include "core/mechanism/model/mechanism.h"
#include "core/presentation/exporters/option_values.h"

namespace geargraph {

/// The mechanism with `--state NAME`: this state engaged, with its input at 1 rad/s; `--engage A,B`: these
/// couplings engaged; `--engage none`: none engaged. Without these options as the document says.
[[nodiscard]] std::variant<Mechanism, UsageError> withEngagementOptions(Mechanism mechanism,
                                                                        const OptionValues& given);

inline constexpr OptionText kStateOption{"--state", "NAME",
                                         toTranslate("with the couplings of this state engaged")};
inline constexpr OptionText kEngageOption{
    "--engage", "A,B",
    toTranslate("with these couplings engaged, \"none\" for no coupling, instead of "
                "those that the document engages")};

}  // namespace geargraph
