#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/cli/arguments.h"
#include "core/presentation/requests/request_server.h"

namespace geargraph::cli {

/// The exit status of every command.
enum ExitStatus {
  kFine = 0,             ///< warnings allowed
  kMechanismErrors = 1,  ///< the mechanism has errors
  kUsageOrFile = 2,      ///< wrong usage, or a file that could not be read or written
  kResourceLimit = 3,    ///< a given resource limit was exceeded
};

/// A command of the command line. It writes results to standard output, everything else to standard error.
struct Command {
  std::string_view name;
  std::string_view usage;    ///< after the name, e.g. "FILE [--json]"
  std::string_view summary;  ///< one line
  std::span<const Option> options;
  int (*run)(const Arguments& arguments);
  bool limitsItself = false;        ///< --limit-seconds does not apply to the whole command
  bool isServed = true;             ///< also a method of `serve`
  std::string (*more)() = nullptr;  ///< what the help says after the options, with an empty line before it
  MethodInput servedInput = MethodInput::document;  ///< what it reads as a method of `serve`
  std::span<const std::string_view> unserved = {};  ///< options that would read or write files
  /// Does it know sliding joints? Else it rejects documents that have some.
  bool knowsSlides = false;
};

extern const Command kAnalyze;
extern const Command kValidate;
extern const Command kInputs;
extern const Command kStates;
extern const Command kLevers;
extern const Command kVibration;
extern const Command kBacklash;
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
extern const Command kTeeth;
extern const Command kManual;
extern const Command kAtlas;
extern const Command kIdentify;
extern const Command kGearbox;
extern const Command kHardware;

/// Runs a command with these arguments, with a time limit in seconds if given. Returns the exit status. May
/// throw std::bad_alloc.
int runCommand(const Command& command, const std::vector<std::string>& words, std::optional<double> seconds);
/// The command's own options, then those common to all commands.
[[nodiscard]] std::vector<Option> optionsOf(const Command& command);

/// All commands, in the order of the help.
[[nodiscard]] std::span<const Command* const> commands();

/// Reports wrong usage of a command; returns the exit status.
int wrongUsage(const Command& command, std::string_view message);
/// Reports what could not be read or written; returns the exit status.
int fileFailure(std::string_view message);
/// Writes a file whole or not at all, or to standard output for "-"; returns the exit status.
int writeOutput(std::string_view bytes, const std::string& path);
/// Writes text to standard output; returns the exit status, `fine` if all of it was written.
int print(std::string_view text, int fine = kFine);

}  // namespace geargraph::cli
