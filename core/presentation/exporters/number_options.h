#pragma once

#include <functional>
#include <optional>
#include <string_view>
#include <variant>

#include "core/presentation/exporters/option_values.h"

namespace geargraph {

/// The number of an option, or `otherwise` if it is not given. An error if it is not in [least, most].
[[nodiscard]] std::variant<double, UsageError> numberWithin(const OptionValues& given,
                                                            std::string_view option, double otherwise,
                                                            double least, double most);

/// Three numbers with commas between them, each read by `read`; std::nullopt for anything else.
[[nodiscard]] std::optional<NumberTriple> tripleFrom(
    std::string_view text,
    const std::function<std::optional<Number>(std::string_view text)>& read = typedNumber);

}  // namespace geargraph
