#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/command.h"

namespace geargraph::cli {

/// The resource limits of a served command.
struct ServedLimits {
  std::optional<double> seconds;
  std::optional<std::size_t> megabytes;  ///< of address space
};

/// The result of a served command.
struct ServedOutcome {
  /// The exit status; std::nullopt if the process was killed at a limit or crashed.
  std::optional<int> status;
  std::string output;
  std::string messages;  ///< standard error
  std::string failure;   ///< why there is no status, as a sentence
};

/// What a served command reads: "-" among its words is the first text, kSecondInput the second.
struct ServedTexts {
  std::string first;
  std::string second;
};
constexpr std::string_view kSecondInput = "/second input/";

/// Runs a command in a child process, with the first text as its standard input, so that limits of time and
/// memory terminate only the child, not the server. Cost: a fork. @pre the program has only one thread
[[nodiscard]] ServedOutcome runServed(const Command& command, std::vector<std::string> words,
                                      const ServedTexts& texts, const ServedLimits& limits);

}  // namespace geargraph::cli
