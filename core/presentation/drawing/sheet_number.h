#pragma once

#include <string>

namespace geargraph {

/// A coordinate of a drawing in a text: to a hundredth, without trailing zeros, whatever the locale.
/// @pre finite
[[nodiscard]] std::string sheetNumber(double value);

}  // namespace geargraph
