#pragma once

#include <string>
#include <string_view>

#include "core/foundations/base/rational.h"

namespace geargraph {

// Numbers as people read them, on screen, in reports and in printed tables. Exact values belong in JSON, CSV
// and tooltips.

/// Characters of the longest fraction that people are shown.
constexpr std::size_t kMaxReadableFraction = 9;

/// Is `number` a fraction ("-5080983/250000") of which people are shown the decimal instead?
[[nodiscard]] bool isLongFraction(std::string_view number);

/// About six significant digits with the decimal sign of the language: "-0.000225691", "0" for both zeros.
[[nodiscard]] std::string readableNumber(double value);

/// The number itself where it is whole or a short fraction, "-8/3"; else as above.
[[nodiscard]] std::string readableNumber(const Rational& value);

}  // namespace geargraph
