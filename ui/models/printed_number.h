#pragma once

#include <QString>

#include "core/foundations/base/rational.h"

namespace geargraph::inline models {

/// A number with a Unicode minus sign; a long fraction is given to about six digits.
[[nodiscard]] QString printedFraction(const Rational& value);
/// With the decimal sign of the window's language.
[[nodiscard]] QString printedNumber(double value);

}  // namespace geargraph::inline models
