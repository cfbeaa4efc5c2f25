#pragma once

#include <string_view>
#include <variant>

#include "app/cli/arguments.h"

namespace geargraph::cli {

/// The number of an option, or `otherwise` if it is not given. An error if it is not in [least, most].
[[nodiscard]] std::variant<double, UsageError> numberWithin(const Arguments& arguments,
                                                            std::string_view option, double otherwise,
                                                            double least, double most);

}  // namespace geargraph::cli
