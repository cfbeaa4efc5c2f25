#include "app/cli/command.h"

#include <array>
#include <charconv>
#include <iostream>

#include "app/cli/time_limit.h"
#include "core/foundations/base/translation.h"
#include "core/foundations/files/file.h"

namespace geargraph::cli {
namespace {

/// "2.5", as the option gives it.
std::string writtenSeconds(double seconds) {
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), seconds).ptr};
}

}  // namespace

std::span<const Command* const> commands() {
  static constexpr std::array kCommands = {
      &kAnalyze,  &kValidate, &kInputs,  &kStates, &kLevers,   &kVibration, &kBacklash,  &kStatics,
      &kDynamics, &kExport,   &kConvert, &kPose,   &kSummary,  &kServe,     &kExercises, &kLesson,
      &kCheck,    &kTeeth,    &kManual,  &kAtlas,  &kIdentify, &kGearbox,   &kHardware};
  return kCommands;
}

std::vector<Option> optionsOf(const Command& command) {
  std::vector<Option> options(command.options.begin(), command.options.end());
  options.push_back(kLimitOption);
  return options;
}

int runCommand(const Command& command, const std::vector<std::string>& words, std::optional<double> seconds) {
  auto parsed = parseArguments(words, optionsOf(command));
  if (const auto* error = std::get_if<UsageError>(&parsed)) return wrongUsage(command, error->message);
  auto& arguments = std::get<Arguments>(parsed);
  if (!seconds) {
    const auto given = limitFrom(arguments);
    if (const auto* error = std::get_if<UsageError>(&given)) return wrongUsage(command, error->message);
    seconds = std::get<0>(given);
  } else {
    arguments.options[std::string(kLimitOption.name)] = {writtenSeconds(*seconds)};
  }
  const TimeLimit limit(command.limitsItself ? std::nullopt : seconds);
  arguments.stop = limit.token();
  return command.run(arguments);
}

int wrongUsage(const Command& command, std::string_view message) {
  std::cerr << "geargraph-cli " << command.name << ": " << message << '\n'
            << translated("Usage: geargraph-cli %1 %2", {command.name, command.usage}) << '\n'
            << translated("More: geargraph-cli %1 --help", {command.name}) << '\n';
  return kUsageOrFile;
}

int fileFailure(std::string_view message) {
  std::cerr << "geargraph-cli: " << message << '\n';
  return kUsageOrFile;
}

int writeOutput(std::string_view bytes, const std::string& path) {
  if (path == "-") return print(bytes);
  const auto error = writeFile(path, bytes);
  return error ? fileFailure(error->message) : kFine;
}

int print(std::string_view text, int fine) {
  StandardOutput out;
  out.write(text);
  return out.failed() ? fileFailure(translated("Standard output could not be written.")) : fine;
}

}  // namespace geargraph::cli
