#pragma once

#include <variant>

#include "app/cli/arguments.h"
#include "app/cli/command.h"
#include "core/mechanism/model/mechanism.h"
#include "core/presentation/exporters/engagement_options.h"

namespace geargraph::cli {

/// Reads the document that the arguments name and applies withEngagementOptions(). On failure it reports the
/// reason on standard error and returns the exit status.
[[nodiscard]] std::variant<Mechanism, int> loadEngaged(const Command& command, const Arguments& arguments);

/// The name of the document, "Mechanism" if it has none.
[[nodiscard]] std::string titleOf(const Mechanism& mechanism);

/// The engaged couplings for use in a sentence: "A, B (state 3)"; empty: none.
[[nodiscard]] std::string engagementText(const Mechanism& mechanism);

}  // namespace geargraph::cli
