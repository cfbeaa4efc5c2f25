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

#include "core/foundations/base/decimal.h"

namespace geargraph::cli {

/// An option that a command knows. Options with a value take it as `--name value` or `--name=value`; one that
/// is given several times has several values.
struct Option {
  std::string_view name;   ///< "--matrix", "-o"
  std::string_view value;  ///< what stands for the value in the help, e.g. "NAME"; empty where there is none
  std::string_view help;
  std::string_view group = {};  ///< the heading that the help lists it under; empty: "Options"
};

/// The words after a command, sorted.
struct Arguments {
  std::vector<std::string> files;
  std::map<std::string, std::vector<std::string>, std::less<>> options;
  std::stop_token stop;  ///< of the time limit (time_limit.h)

  [[nodiscard]] bool has(std::string_view option) const { return options.contains(option); }
  /// The last value of the option, if it was given.
  [[nodiscard]] std::optional<std::string> value(std::string_view option) const;
  [[nodiscard]] std::vector<std::string> values(std::string_view option) const;
};

/// The number that a text is, and nothing else.
template <class Number>
[[nodiscard]] std::optional<Number> numberFrom(std::string_view text) {
  if constexpr (std::is_floating_point_v<Number>) {
    return decimalFrom(text);
  } else {
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return value;
  }
}

/// What is wrong with the words, as a sentence.
struct UsageError {
  std::string message;
};

/// Sorts words into options and files, by CLI11; "-" is a file, and so is everything after "--".
[[nodiscard]] std::variant<Arguments, UsageError> parseArguments(std::span<const std::string> words,
                                                                 std::span<const Option> known);

}  // namespace geargraph::cli
