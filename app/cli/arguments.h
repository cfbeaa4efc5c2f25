#pragma once

#include <charconv>
#include <map>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "core/mechanism/model/quantity.h"

namespace geargraph::cli {

/// An option of a command. A value is given as `--name value` or `--name=value`; an option may be given
/// several times.
struct Option {
  std::string_view name;   ///< "--matrix", "-o"
  std::string_view value;  ///< placeholder of the value in the help, e.g. "NAME"; empty: none
  std::string_view help;
  std::string_view group = {};  ///< its heading in the help; empty: "Options"
};

/// The parsed arguments of a command.
struct Arguments {
  std::vector<std::string> files;
  std::map<std::string, std::vector<std::string>, std::less<>> options;
  std::stop_token stop;  ///< of the time limit (time_limit.h)

  [[nodiscard]] bool has(std::string_view option) const { return options.contains(option); }
  /// The last value of the option; std::nullopt if it was not given.
  [[nodiscard]] std::optional<std::string> value(std::string_view option) const;
  [[nodiscard]] std::vector<std::string> values(std::string_view option) const;
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

/// What is wrong with the arguments, as a sentence.
struct UsageError {
  std::string message;
};

/// Parses words into options and files with CLI11; "-" is a file, and so is everything after "--".
[[nodiscard]] std::variant<Arguments, UsageError> parseArguments(std::span<const std::string> words,
                                                                 std::span<const Option> known);

}  // namespace geargraph::cli
