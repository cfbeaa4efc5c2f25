#pragma once

#include <QString>

#include "core/foundations/base/rational.h"
#include "core/foundations/exact/pi_number.h"

namespace geargraph {

/// A number with a Unicode minus sign; a long fraction is given to about six digits.
[[nodiscard]] QString printedFraction(const Rational& value);
/// The same with powers of pi: "5/2/π", "20·π".
[[nodiscard]] QString printedExact(const PiNumber& value);
/// With the decimal sign of the window's language. `digits` and `format` as for QString::number().
[[nodiscard]] QString printedNumber(double value, int digits = 6, char format = 'g');
/// The same text with Unicode minus signs.
[[nodiscard]] QString withPrintedMinus(QString text);

}  // namespace geargraph
