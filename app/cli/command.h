#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/cli/arguments.h"

namespace geargraph::cli {

/// The exit status of every command.
enum ExitStatus {
  kFine = 0,             ///< warnings allowed
  kMechanismErrors = 1,  ///< the mechanism has errors
  kUsageOrFile = 2,      ///< wrong usage, or a file that could not be read or written
  kResourceLimit = 3,    ///< out of a stated resource limit
};

/// One command: what it is called with, and what it does. Results go to standard output, everything else to
/// standard error.
struct Command {
  std::string_view name;
  std::string_view usage;    ///< behind the name, e.g. "FILE [--json]"
  std::string_view summary;  ///< one line
  std::span<const Option> options;
  int (*run)(const Arguments& arguments);
  bool limitsItself = false;  ///< --limit-seconds is not for the whole of it
  bool isServed = true;       ///< also a method of `serve`: it reads one document
};

extern const Command kAnalyze;
extern const Command kValidate;
extern const Command kInputs;
extern const Command kStates;
extern const Command kStatics;
extern const Command kDynamics;
extern const Command kExport;
extern const Command kConvert;
extern const Command kPose;
extern const Command kSummary;
extern const Command kServe;
extern const Command kExercises;
extern const Command kLesson;
extern const Command kCheck;
extern const Command kManual;

/// Runs a command with its words, within `seconds`; the exit status. May throw std::bad_alloc.
int runCommand(const Command& command, const std::vector<std::string>& words, std::optional<double> seconds);
/// Its own options, and those of every command.
[[nodiscard]] std::vector<Option> optionsOf(const Command& command);

/// Every command, in the order of the help.
[[nodiscard]] std::span<const Command* const> commands();

/// Reports wrong usage of a command and returns its exit status.
int wrongUsage(const Command& command, std::string_view message);
/// Reports what could not be read or written and returns the exit status.
int fileFailure(std::string_view message);
/// Writes text to standard output; the exit status, `fine` where all of it was taken.
int print(std::string_view text, int fine = kFine);

}  // namespace geargraph::cli
