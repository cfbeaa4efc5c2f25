#pragma once

#include <QString>

#include "core/foundations/base/rational.h"

namespace geargraph::inline models {

/// A fraction with the minus sign of print, or about six digits of it if it is long.
[[nodiscard]] QString printedFraction(const Rational& value);
/// With the decimal sign of the window's language.
[[nodiscard]] QString printedNumber(double value);

}  // namespace geargraph::inline models
