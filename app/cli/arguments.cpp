#include "app/cli/arguments.h"

#include <algorithm>

namespace geargraph::cli {

std::optional<std::string> Arguments::value(std::string_view option) const {
  const auto found = options.find(option);
  if (found == options.end()) return std::nullopt;
  return found->second.back();
}

std::vector<std::string> Arguments::values(std::string_view option) const {
  const auto found = options.find(option);
  return found == options.end() ? std::vector<std::string>{} : found->second;
}

std::variant<Arguments, UsageError> parseArguments(std::span<const std::string> words,
                                                   std::span<const Option> known) {
  Arguments arguments;
  bool onlyFiles = false;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    if (onlyFiles || word.size() < 2 || word.front() != '-') {
      arguments.files.push_back(word);
      continue;
    }
    if (word == "--") {
      onlyFiles = true;
      continue;
    }
    const std::size_t equals = word.starts_with("--") ? word.find('=') : std::string::npos;
    const std::string name = word.substr(0, equals);
    const auto option =
        std::find_if(known.begin(), known.end(), [&](const Option& o) { return o.name == name; });
    if (option == known.end()) return UsageError{"There is no option \"" + name + "\" here."};
    std::string value;
    if (option->value.empty()) {
      if (equals != std::string::npos) return UsageError{"The option " + name + " takes no value."};
    } else if (equals != std::string::npos) {
      value = word.substr(equals + 1);
    } else if (i + 1 < words.size()) {
      value = words[++i];
    } else {
      return UsageError{"The option " + name + " needs a value: " + name + " " + std::string(option->value) +
                        "."};
    }
    arguments.options[name].push_back(value);
  }
  return arguments;
}

}  // namespace geargraph::cli
