#pragma once

#include <string_view>
#include <variant>

#include "app/cli/arguments.h"
#include "core/presentation/exporters/number_options.h"

namespace geargraph::cli {

/// The angle of a word like "8=30deg", which has to have its unit; an error says how both are written.
[[nodiscard]] std::variant<TypedAngle, UsageError> angleOption(std::string_view option,
                                                               std::string_view word);

}  // namespace geargraph::cli
