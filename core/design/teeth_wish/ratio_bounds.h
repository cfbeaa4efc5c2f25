#pragma once

#include <optional>
#include <string_view>

#include "core/foundations/base/rational.h"

namespace geargraph {

/// The interval of ratios that a wish accepts. Every comparison with it is one of fractions.
struct RatioBounds {
  Rational wanted;  ///< what errors are measured against; the middle of a stated interval
  Rational low;
  Rational high;
  bool includesHigh = true;  ///< false for a rounded decimal: 0.632 is 0.6315 <= ratio < 0.6325

  [[nodiscard]] bool contains(const Rational& ratio) const {
    return low <= ratio && (includesHigh ? ratio <= high : ratio < high);
  }
  /// (ratio - wanted) / |wanted|.
  [[nodiscard]] Rational errorOf(const Rational& ratio) const { return (ratio - wanted) / wanted.abs(); }
  friend bool operator==(const RatioBounds&, const RatioBounds&) = default;
};

/// The ratio itself within a relative tolerance, both ends inclusive. @pre ratio is not 0, 0 <= tolerance < 1
[[nodiscard]] RatioBounds boundsWithin(const Rational& ratio, const Rational& tolerance);
/// An interval, both ends inclusive. @pre low <= high, and 0 is not between them
[[nodiscard]] RatioBounds boundsBetween(const Rational& low, const Rational& high);
/// A ratio as it is written: a whole number or a fraction stands for itself alone, a decimal ("0.632") for
/// all that round to it, half a unit of its last digit to both sides, the lower end inclusive. std::nullopt
/// if the text is no number, or an interval would contain 0.
[[nodiscard]] std::optional<RatioBounds> boundsOf(std::string_view written);

}  // namespace geargraph
