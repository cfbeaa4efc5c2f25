#pragma once

#include <string_view>

#include "core/foundations/base/rational.h"

namespace geargraph::inline grading {

enum class NumberFault { none, notANumber, ambiguous };

/// A number written by a learner.
struct WrittenNumber {
  NumberFault fault = NumberFault::none;
  Rational value;
  /// The tolerance of a decimal with at least three significant digits, which may be rounded or truncated:
  /// one unit of its last place, exclusive. 0 for all other numbers.
  Rational slack;

  [[nodiscard]] bool agreesWith(const Rational& expected) const {
    return fault == NumberFault::none && (value == expected || (value - expected).abs() < slack);
  }
};

/// Evaluates whole numbers, fractions, decimals with a point or a comma, and expressions of them with + - * /
/// and parentheses, exactly: "-16/27", "0,75", "18 : 36", "-(2/3)·4". ×, ·, ÷, : and dashes are also
/// accepted.
///
/// "1,250" may be a decimal or have a thousands separator: `ambiguous`; "0,250" and "1,25" are not. A point
/// is always a decimal point. At most 200 bytes and 20 levels of parentheses.
[[nodiscard]] WrittenNumber readNumber(std::string_view text);

}  // namespace geargraph::inline grading
