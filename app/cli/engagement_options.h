#pragma once

#include <variant>

#include "app/cli/arguments.h"
#include "app/cli/command.h"
#include "core/foundations/base/words.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph::cli {

/// `--state NAME`: the mechanism with this state put in, its drive at 1 rad/s; `--engage A,B`: with these
/// couplings engaged; `--engage none`: with none. Without them as the document engages its couplings.
[[nodiscard]] std::variant<Mechanism, UsageError> withEngagementOptions(Mechanism mechanism,
                                                                        const Arguments& arguments);

/// The document of the file that the arguments name, so engaged. Where there is none, standard error says
/// why, and the result is the exit status.
[[nodiscard]] std::variant<Mechanism, int> loadEngaged(const Command& command, const Arguments& arguments);

inline constexpr Option kStateOption{"--state", "NAME",
                                     toTranslate("with the couplings of this state engaged")};
inline constexpr Option kEngageOption{
    "--engage", "A,B",
    toTranslate("with these couplings engaged, \"none\" for no coupling, instead of "
                "those that the document engages")};

/// "A, B (state 3)": what is engaged, as a sentence names it; empty for nothing.
[[nodiscard]] std::string engagementText(const Mechanism& mechanism);

}  // namespace geargraph::cli
