#pragma once

#include <map>
#include <string>
#include <string_view>

#include "core/foundations/base/rational.h"
#include "core/teaching/grading/expression_reader.h"

namespace geargraph {

enum class NumberFault { none, notANumber, ambiguous, unknownName, otherUnit };

/// Symbols that a number may be written in, with their values: "i15" -> "1/2".
using NumberSymbols = std::map<std::string, std::string>;

/// How a number may be written.
struct NumberNotation {
  CommaUse comma = CommaUse::ambiguous;
  std::string unit = {};  ///< that may follow: "rad/s", "N m" or none
  NumberSymbols symbols = {};
};

/// A number written by a learner.
struct WrittenNumber {
  NumberFault fault = NumberFault::none;
  Rational value;
  /// The tolerance of decimals with at least three significant digits (ExpressionReader), exclusive. 0 for
  /// exact numbers.
  Rational slack;
  std::string place = {};  ///< of a fault: the part of the text that cannot be read

  [[nodiscard]] bool agreesWith(const Rational& expected) const {
    return fault == NumberFault::none && (value == expected || (value - expected).abs() < slack);
  }
};

/// The use of commas in the current language.
[[nodiscard]] CommaUse commaUse();

/// Evaluates a number exactly: whole numbers, fractions, decimals with a point or a comma, and what + - * / ^
/// and parentheses make of them and of symbols: "-16/27", "0,75", "18 : 36", "-2.667e0", "98%", "-N4/N1".
/// Signs of print and LaTeX are also accepted.
///
/// The unit of the notation may follow, or a multiple of it ("2 kN m"). In the notation of decimal points
/// "1,250" may be a decimal or have a thousands separator: `ambiguous`; "0,250" and "1,25" are not. A point
/// is always a decimal point. At most 200 bytes.
[[nodiscard]] WrittenNumber readNumber(std::string_view text, const NumberNotation& notation = {});

}  // namespace geargraph
