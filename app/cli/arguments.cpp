#include "app/cli/arguments.h"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "core/foundations/base/translation.h"

namespace geargraph::cli {
namespace {

/// "--name=" gives an empty value, which CLI11 would look for in the next word.
std::vector<std::string> withEmptyValuesApart(std::span<const std::string> words,
                                              std::span<const Option> known) {
  std::vector<std::string> apart;
  for (const std::string& word : words) {
    const bool isApart = std::any_of(known.begin(), known.end(), [&](const Option& option) {
      return !option.value.empty() && word == std::string(option.name) + '=';
    });
    apart.push_back(isApart ? word.substr(0, word.size() - 1) : word);
    if (isApart) apart.emplace_back();
  }
  return apart;
}

/// What is wrong, from the two ways in which a known option can be given wrongly.
UsageError mismatch(std::span<const std::string> words, std::span<const Option> known) {
  for (const Option& option : known) {
    const std::string name(option.name);
    const auto hasValue = [&](const std::string& word) { return word.starts_with(name + '='); };
    if (option.value.empty() && std::any_of(words.begin(), words.end(), hasValue))
      return {translated("The option %1 takes no value.", {name})};
    if (!option.value.empty() && words.back() == name)
      return {translated("The option %1 needs a value: %1 %2.", {name, option.value})};
  }
  return {translated("The options cannot be read.")};
}

}  // namespace

std::variant<Arguments, UsageError> parseArguments(std::span<const std::string> words,
                                                   std::span<const Option> known) {
  CLI::App parser;
  parser.set_help_flag();  // help is the program's (main.cpp)
  parser.allow_extras();   // files, and options that are not known
  std::vector<CLI::Option*> options;
  for (const Option& option : known) {
    const std::string name(option.name);
    options.push_back(option.value.empty() ? parser.add_flag(name)->disable_flag_override()
                                           : parser.add_option(name));
    options.back()->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  }
  std::vector<std::string> next = withEmptyValuesApart(words, known);
  std::reverse(next.begin(), next.end());
  try {
    parser.parse(std::move(next));
  } catch (const CLI::ParseError&) {
    return mismatch(words, known);
  }
  Arguments arguments;
  bool onlyFiles = false;
  for (const std::string& word : parser.remaining()) {
    if (onlyFiles || word.size() < 2 || word.front() != '-') {
      arguments.files.push_back(word);
    } else if (word == "--") {
      onlyFiles = true;
    } else {
      return UsageError{translated("There is no option \"%1\" here.", {word.substr(0, word.find('='))})};
    }
  }
  for (std::size_t i = 0; i < known.size(); ++i) {
    if (options[i]->count() > 0) arguments.options[std::string(known[i].name)] = options[i]->results();
  }
  return arguments;
}

}  // namespace geargraph::cli
