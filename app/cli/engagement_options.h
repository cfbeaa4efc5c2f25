#pragma once

#include <variant>

#include "app/cli/arguments.h"
#include "app/cli/command.h"
#include "core/foundations/base/words.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph::cli {

/// The mechanism with `--state NAME`: this state engaged, with its input at 1 rad/s; `--engage A,B`: these
/// couplings engaged; `--engage none`: none engaged. Without these options as the document says.
[[nodiscard]] std::variant<Mechanism, UsageError> withEngagementOptions(Mechanism mechanism,
                                                                        const Arguments& arguments);

/// Reads the document that the arguments name and applies withEngagementOptions(). On failure it reports the
/// reason on standard error and returns the exit status.
[[nodiscard]] std::variant<Mechanism, int> loadEngaged(const Command& command, const Arguments& arguments);

inline constexpr Option kStateOption{"--state", "NAME",
                                     toTranslate("with the couplings of this state engaged")};
inline constexpr Option kEngageOption{
    "--engage", "A,B",
    toTranslate("with these couplings engaged, \"none\" for no coupling, instead of "
                "those that the document engages")};

/// The name of the document, "Mechanism" if it has none.
[[nodiscard]] std::string titleOf(const Mechanism& mechanism);

/// The engaged couplings for use in a sentence: "A, B (state 3)"; empty: none.
[[nodiscard]] std::string engagementText(const Mechanism& mechanism);

}  // namespace geargraph::cli
