#pragma once

#include <optional>
#include <string_view>

namespace geargraph {

/// The value of a decimal text such as "-1.5e3", independent of the locale. std::nullopt if the text as a
/// whole is not a number, or a double cannot hold it. Uses std::from_chars if the library has it for doubles.
[[nodiscard]] std::optional<double> decimalFrom(std::string_view text);

}  // namespace geargraph
