#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/command.h"

namespace geargraph::cli {

/// What a served command may take.
struct ServedLimits {
  std::optional<double> seconds;
  std::optional<std::size_t> megabytes;  ///< of address space
};

/// What a command has given.
struct ServedOutcome {
  /// As the process would have ended; none if it was ended for its limits or crashed.
  std::optional<int> status;
  std::string output;
  std::string messages;  ///< standard error
  std::string failure;   ///< why there is no status, as a sentence
};

/// Runs a command in a process of its own, with the document as its standard input ("-" among the words), so
/// that its limits hold whatever it does: time and memory end this process and not the server.
/// Cost: a fork.
/// @pre the program has one thread
[[nodiscard]] ServedOutcome runServed(const Command& command, const std::vector<std::string>& words,
                                      const std::string& document, const ServedLimits& limits);

}  // namespace geargraph::cli
