// `geargraph-cli`: finds the command, sorts its words, and runs it.

#include <algorithm>
#include <iostream>
#include <new>
#include <string>
#include <vector>

#include "app/cli/command.h"
#include "app/cli/language.h"
#include "core/foundations/base/translation.h"

namespace geargraph::cli {
namespace {

constexpr const char* kExitStatus = toTranslate(
    "Exit status: 0 fine (warnings allowed), 1 the mechanism has errors, 2 wrong usage or a file that could "
    "not be read or\nwritten, 3 out of a stated resource limit. \"-\" is standard input or output.");

std::string programHelp() {
  std::string text = translated("geargraph-cli: the analysis of geared mechanisms, without a window.") +
                     "\n\n" + translated("Usage: geargraph-cli %1 %2", {"COMMAND", "FILE [OPTIONS]"}) +
                     "\n\n" + translated("Commands:") + '\n';
  for (const Command* command : commands()) {
    text += "  " + std::string(command->name) + std::string(12 - command->name.size(), ' ');
    text += translated(command->summary) + '\n';
  }
  return text + '\n' +
         translated(
             "--help, --version and --language en|de|tr|es (that of the environment) work on every "
             "command.") +
         '\n' + translated(kExitStatus) + '\n';
}

std::string optionLine(const Option& option) {
  constexpr std::size_t kIndent = 28;
  std::string line = "  " + std::string(option.name);
  if (!option.value.empty()) line += ' ' + std::string(option.value);
  line.resize(std::max(line.size() + 1, kIndent), ' ');
  return line + (option.composedHelp != nullptr ? option.composedHelp() : translated(option.help)) + '\n';
}

std::string headingOf(const Option& option) {
  if (option.group.empty()) return translated("Options");
  return option.composedHeading != nullptr ? option.composedHeading(option.group) : translated(option.group);
}

std::string commandHelp(const Command& command) {
  std::string text = translated("Usage: geargraph-cli %1 %2", {command.name, command.usage}) + "\n\n" +
                     translated(command.summary) + '\n';
  const std::vector<Option> options = optionsOf(command);
  std::vector<const Option*> firstOfGroups;
  for (const Option& option : options) {
    if (std::none_of(firstOfGroups.begin(), firstOfGroups.end(),
                     [&](const Option* first) { return first->group == option.group; }))
      firstOfGroups.push_back(&option);
  }
  std::stable_partition(firstOfGroups.begin(), firstOfGroups.end(),
                        [](const Option* first) { return first->group.empty(); });
  for (const Option* const first : firstOfGroups) {
    text += '\n' + headingOf(*first) + ":\n";
    for (const Option& option : options) {
      if (option.group == first->group) text += optionLine(option);
    }
  }
  if (command.more != nullptr) text += command.more();
  return text + '\n' + translated(kExitStatus) + '\n';
}

bool contains(const std::vector<std::string>& words, std::string_view wanted) {
  const auto end = std::find(words.begin(), words.end(), "--");
  return std::find(words.begin(), end, wanted) != end;
}

int run(std::vector<std::string> words) {
  const auto chosen = takeLanguage(words);
  if (const auto* error = std::get_if<UsageError>(&chosen)) {
    std::cerr << "geargraph-cli: " << error->message << '\n';
    return kUsageOrFile;
  }
  speakLanguage(std::get<std::optional<std::string>>(chosen), words);
  const std::string version = "geargraph-cli " GEARGRAPH_VERSION "\n";
  const std::string name = words.empty() ? "" : words.front();
  const auto command =
      std::find_if(commands().begin(), commands().end(), [&](const Command* c) { return c->name == name; });
  if (command == commands().end()) {
    if (contains(words, "--version")) return print(version);
    if (contains(words, "--help")) return print(programHelp());
    if (!name.empty())
      std::cerr << "geargraph-cli: " << translated("There is no command \"%1\".", {name}) << "\n\n";
    std::cerr << programHelp();
    return kUsageOrFile;
  }
  const std::vector<std::string> rest(words.begin() + 1, words.end());
  if (contains(rest, "--help")) return print(commandHelp(**command));
  if (contains(rest, "--version")) return print(version);
  return runCommand(**command, rest, std::nullopt);
}

}  // namespace
}  // namespace geargraph::cli

int main(int count, char** words) {
  try {
    return geargraph::cli::run({words + 1, words + std::max(count, 1)});
  } catch (const std::bad_alloc&) {
    std::cerr << "geargraph-cli: " << geargraph::translated("The memory does not suffice for this mechanism.")
              << '\n';
    return geargraph::cli::kResourceLimit;
  }
}
