#pragma once

#include <string_view>

#include "core/foundations/base/rational.h"

namespace geargraph::inline grading {

enum class NumberFault { none, notANumber, ambiguous };

/// A number as a learner writes it.
struct WrittenNumber {
  NumberFault fault = NumberFault::none;
  Rational value;
  /// A decimal of at least three significant digits may have been rounded or cut off: it agrees with every
  /// value that is nearer than one unit of its last place. 0 for all other numbers.
  Rational slack;

  [[nodiscard]] bool agreesWith(const Rational& expected) const {
    return fault == NumberFault::none && (value == expected || (value - expected).abs() < slack);
  }
};

/// Reads whole numbers, fractions, decimals with a point or a comma, and what + - * / and parentheses make of
/// them, exactly: "-16/27", "0,75", "18 : 36", "-(2/3)·4". ×, ·, ÷, : and the dashes are read, too.
///
/// "1,250" may be a decimal or a thousand: ambiguous; "0,250" and "1,25" are not. A point is always a decimal
/// point. At most 200 bytes and 20 parentheses inside each other.
[[nodiscard]] WrittenNumber readNumber(std::string_view text);

}  // namespace geargraph::inline grading
