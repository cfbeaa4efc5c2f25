// `serve --stdio`: answers requests, one JSON object a line, until standard input ends.

#include <algorithm>
#include <array>
#include <iostream>
#include <utility>
#include <vector>

#include "app/cli/command.h"
#include "app/cli/served_command.h"
#include "app/cli/served_folder.h"
#include "app/cli/time_limit.h"
#include "core/foundations/base/translation.h"
#include "core/foundations/files/file.h"
#include "core/mechanism/document_format/mechanism_file.h"
#include "core/presentation/requests/request_server.h"

namespace geargraph::cli {
namespace {

constexpr std::size_t kLargestRequest = 2 * kLargestFile;

/// The commands that are methods, too.
std::vector<HostedMethod> servedMethods() {
  std::vector<HostedMethod> methods;
  for (const Command* const command : commands()) {
    if (!command->isServed) continue;
    HostedMethod method{command->name,
                        command->servedInput,
                        optionsOf(*command),
                        {command->unserved.begin(), command->unserved.end()}};
    std::erase_if(method.options, [&](const Option& option) {
      return std::find(method.refusedOptions.begin(), method.refusedOptions.end(), option.name) !=
             method.refusedOptions.end();
    });
    methods.push_back(std::move(method));
  }
  return methods;
}

const Command& commandNamed(std::string_view name) {
  return **std::find_if(commands().begin(), commands().end(),
                        [&](const Command* command) { return command->name == name; });
}

/// As runServed(); an export of a folder writes where nothing of it is left, and its files are in the
/// outcome.
HostedOutcome runHosted(const Command& command, std::vector<std::string> words, const HostedTexts& texts,
                        const ServedLimits& limits) {
  if (&command != &kExport || !asksForFolder(words))
    return runServed(command, std::move(words), texts, limits);
  HostedOutcome outcome;
  const auto output = std::find(words.begin(), words.end(), "-o");
  if (output == words.end()) {
    outcome.failureCode = "request";
    outcome.failure = "A folder needs -o \"-\".";
    return outcome;
  }
  const ServedFolder folder;
  if (!folder.isMade()) {
    outcome.failure = "There is no place for files until they are sent.";
    return outcome;
  }
  *(output + 1) = folder.path();
  outcome = runServed(command, std::move(words), texts, limits);
  outcome.files = folder.files();
  if (outcome.status == kFine && !outcome.files) {
    outcome.status.reset();
    outcome.failure = "The files of the folder cannot be read, or one is too large.";
  }
  return outcome;
}

/// The next line of standard input, without its end; none at the end, or where it is too long.
std::optional<std::string> nextLine() {
  std::string line;
  for (int c = std::cin.get(); c != std::char_traits<char>::eof(); c = std::cin.get()) {
    if (c == '\n') return line;
    line += static_cast<char>(c);
    if (line.size() > kLargestRequest) {
      std::cerr << "geargraph-cli: A request of over 128 MiB ends the program.\n";
      return std::nullopt;
    }
  }
  return line.empty() ? std::nullopt : std::optional(line);
}

int runServe(const Arguments& arguments) {
  if (!arguments.files.empty() || !arguments.has("--stdio"))
    return wrongUsage(kServe, "--stdio is needed, and no file.");
  const auto seconds = limitFrom(arguments);
  if (const auto* error = std::get_if<UsageError>(&seconds)) return wrongUsage(kServe, error->message);
  ServedLimits limits{std::get<0>(seconds), {}};
  if (const auto word = arguments.value("--limit-memory")) {
    limits.megabytes = numberFrom<std::size_t>(*word);
    constexpr std::size_t kMaxMegabytes = 1'000'000;
    if (!limits.megabytes || *limits.megabytes == 0 || *limits.megabytes > kMaxMegabytes)
      return wrongUsage(kServe, "--limit-memory takes whole megabytes from 1 to 1000000.");
  }
  RequestServer server(servedMethods(), [&](const HostedMethod& method, std::vector<std::string> words,
                                            const HostedTexts& texts) {
    return runHosted(commandNamed(method.name), std::move(words), texts, limits);
  });
  StandardOutput out;
  while (const auto line = nextLine()) {
    out.write(server.answerTo(*line) + '\n');
    if (out.failed()) return fileFailure("Standard output could not be written.");
  }
  return kFine;
}

std::string methodsHelp() {
  return requestMethodsText(servedMethods());
}

constexpr std::array kServeOptions = {
    Option{"--stdio", "", toTranslate("requests on standard input, answers on standard output")},
    Option{"--limit-memory", "MB", toTranslate("of address space, for each command")},
};

}  // namespace

const Command kServe = {
    "serve",
    "--stdio [--limit-seconds S] [--limit-memory MB]",
    toTranslate("Answers requests, a JSON object a line: open, edit, analyze, export, ..."),
    kServeOptions,
    runServe,
    true,
    false,
    methodsHelp};

}  // namespace geargraph::cli
