#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/foundations/base/rational.h"

namespace geargraph {

/// A ratio that is wished for: above 0, with the interval that counts as met. Both comparisons are exact.
struct WantedRatio {
  std::string text;  ///< as written
  Rational value;
  Rational lowest;
  Rational highest;
  bool isHighestIn = true;

  [[nodiscard]] bool admits(const Rational& ratio) const {
    return lowest <= ratio && (isHighestIn ? ratio <= highest : ratio < highest);
  }
  /// |ratio - value| / value.
  [[nodiscard]] Rational errorOf(const Rational& ratio) const { return (ratio - value).abs() / value; }
};

/// Reads a fraction or a decimal. With `tolerance`, relative to the ratio, both ends count. Without, a
/// decimal is rounded: it stands for half a unit of its last digit to either side, the lower end in, the
/// upper end out; a fraction or a whole number is exact. std::nullopt if the text is no number above 0, or
/// the interval reaches 0.
[[nodiscard]] std::optional<WantedRatio> wantedRatio(std::string_view text,
                                                     const std::optional<Rational>& tolerance);

}  // namespace geargraph
