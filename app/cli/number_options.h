#pragma once

#include <string_view>
#include <variant>

#include "app/cli/arguments.h"

namespace geargraph::cli {

/// The number that an option gives, within bounds; `otherwise` where it is not given.
[[nodiscard]] std::variant<double, UsageError> numberWithin(const Arguments& arguments,
                                                            std::string_view option, double otherwise,
                                                            double least, double most);

}  // namespace geargraph::cli
