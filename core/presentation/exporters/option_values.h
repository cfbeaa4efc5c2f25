#pragma once

#include <charconv>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "core/mechanism/model/quantity.h"

namespace geargraph {

/// What people read about an option: of a command, in its help, and of an exporter, in a dialog too.
struct OptionText {
  std::string_view name;        ///< "--matrix", "-o"
  std::string_view value;       ///< placeholder of the value in the help, e.g. "NAME"; empty: none
  std::string_view help;        ///< to be translated
  std::string_view group = {};  ///< its heading in the help, to be translated; empty: "Options"
  /// The help where it lists names from a registry, in the current language; null: `help`, translated.
  std::string (*composedHelp)() = nullptr;
  /// The same for the heading of a group; null: `group`, translated.
  std::string (*composedHeading)(std::string_view group) = nullptr;
};

/// Options as texts, by name ("--matrix"), with the values of each in the order in which they were given.
struct OptionValues {
  std::map<std::string, std::vector<std::string>, std::less<>> options;

  [[nodiscard]] bool has(std::string_view option) const { return options.contains(option); }
  /// The last value of the option; std::nullopt if it was not given.
  [[nodiscard]] std::optional<std::string> value(std::string_view option) const {
    const auto found = options.find(option);
    return found == options.end() ? std::nullopt : std::optional(found->second.back());
  }
  [[nodiscard]] std::vector<std::string> values(std::string_view option) const {
    const auto found = options.find(option);
    return found == options.end() ? std::vector<std::string>{} : found->second;
  }
};

/// The number that the whole text represents; std::nullopt if it represents none. Numbers with decimals may
/// be expressions (typedNumber()).
template <class Number>
[[nodiscard]] std::optional<Number> numberFrom(std::string_view text) {
  if constexpr (std::is_floating_point_v<Number>) {
    const auto number = typedNumber(text);
    return number ? std::optional(number->value()) : std::nullopt;
  } else {
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return value;
  }
}

/// What is wrong with the options, as a sentence.
struct UsageError {
  std::string message;
};

}  // namespace geargraph
