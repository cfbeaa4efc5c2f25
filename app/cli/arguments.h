#pragma once

#include <span>
#include <stop_token>
#include <string>
#include <variant>
#include <vector>

#include "core/presentation/exporters/option_values.h"

namespace geargraph::cli {

using geargraph::numberFrom;
using geargraph::UsageError;

/// An option of a command. A value is given as `--name value` or `--name=value`; an option may be given
/// several times.
using Option = OptionText;

/// The parsed arguments of a command.
struct Arguments : OptionValues {
  std::vector<std::string> files;
  std::stop_token stop;  ///< of the time limit (time_limit.h)
};

/// Parses words into options and files with CLI11; "-" is a file, and so is everything after "--".
[[nodiscard]] std::variant<Arguments, UsageError> parseArguments(std::span<const std::string> words,
                                                                 std::span<const Option> known);

}  // namespace geargraph::cli
