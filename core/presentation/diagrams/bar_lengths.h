#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "core/foundations/base/rational.h"

namespace geargraph {

/// A place on a bar, as a part of its length from its lower end.
struct BarSpot {
  int bar = 0;
  Rational part;
};

/// What bars beside each other ask of their lengths and heights.
struct BarDemands {
  int bars = 0;
  /// Two spots at one height.
  std::vector<std::pair<BarSpot, BarSpot>> level;
  /// A spot whose height is above all of a bar, or below it, by barClearance() at least.
  struct Pass {
    BarSpot spot;
    int bar = 0;
    bool isAbove = true;
  };
  std::vector<Pass> passes;
};

/// Of the shortest bar.
inline const Rational& barClearance() {
  static const Rational kClearance(1, 5);
  return kClearance;
}

struct BarLengths {
  std::vector<Rational> bottoms;  ///< heights of the lower ends; the lowest is 0
  std::vector<Rational> lengths;  ///< 1 or more
  Rational height;                ///< of all bars together
};

/// The lengths of bars that meet the demands, with the least height, then the least sum of lengths, then the
/// lowest places: a linear program in fractions, by the simplex method in two phases with Bland's rule.
/// std::nullopt if no lengths meet them. Cost: pivots, each demands times bars.
[[nodiscard]] std::optional<BarLengths> barLengths(const BarDemands& demands);

}  // namespace geargraph
