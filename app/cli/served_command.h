#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/command.h"
#include "core/presentation/requests/request_server.h"

namespace geargraph::cli {

/// The resource limits of a served command.
struct ServedLimits {
  std::optional<double> seconds;
  std::optional<std::size_t> megabytes;  ///< of address space
};

/// Runs a command in a child process, with the first text as its standard input, so that limits of time and
/// memory terminate only the child, not the server. Cost: a fork. @pre the program has only one thread
[[nodiscard]] HostedOutcome runServed(const Command& command, std::vector<std::string> words,
                                      const HostedTexts& texts, const ServedLimits& limits);

}  // namespace geargraph::cli
