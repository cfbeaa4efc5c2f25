#pragma once

#include <optional>
#include <string_view>

namespace geargraph::inline base {

/// The double that a decimal text is, such as "-1.5e3", and nothing else, whatever the language in use. None
/// where it is no number, or one that a double cannot hold. std::from_chars, where the library has it for
/// doubles.
[[nodiscard]] std::optional<double> decimalFrom(std::string_view text);

}  // namespace geargraph::inline base
