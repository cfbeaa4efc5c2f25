#pragma once

#include <functional>
#include <optional>
#include <string_view>
#include <variant>

#include "app/cli/arguments.h"

namespace geargraph::cli {

/// The number of an option, or `otherwise` if it is not given. An error if it is not in [least, most].
[[nodiscard]] std::variant<double, UsageError> numberWithin(const Arguments& arguments,
                                                            std::string_view option, double otherwise,
                                                            double least, double most);

/// The angle of a word like "8=30deg", which has to have its unit; an error says how both are written.
[[nodiscard]] std::variant<TypedAngle, UsageError> angleOption(std::string_view option,
                                                               std::string_view word);

/// Three numbers with commas between them, each read by `read`; std::nullopt for anything else.
[[nodiscard]] std::optional<NumberTriple> tripleFrom(
    std::string_view text,
    const std::function<std::optional<Number>(std::string_view text)>& read = typedNumber);

}  // namespace geargraph::cli
