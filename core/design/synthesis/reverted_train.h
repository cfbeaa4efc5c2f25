#pragma once

#include <vector>

#include "core/mechanism/model/mechanism.h"

namespace geargraph {

/// Tooth counts of a reverted train: two external pairs, first with second and third with fourth, where
/// second and third are on one countershaft. Equal sums of teeth give both pairs the same module.
struct RevertedTeeth {
  int first = 20;
  int second = 40;
  int third = 20;
  int fourth = 40;
  [[nodiscard]] Rational ratio() const { return Rational(second, first) * Rational(fourth, third); }
  friend bool operator==(const RevertedTeeth&, const RevertedTeeth&) = default;
};

struct RevertedRequirements {
  Rational ratio = 4;  ///< speed of drive over speed of driven, above 0
  int fewestTeeth = 17;
  int mostTeeth = 100;
};

struct RevertedChoice {
  RevertedTeeth teeth;
  Rational ratio;
  double error = 0;  ///< relative to the required ratio
};

/// Tooth counts within the limits, nearest to the required ratio first, among equals the smallest first, one
/// for each ratio; at most `most`. Of two choices that differ only by exchanging the pairs, the one with the
/// smaller first ratio is returned. Cost: O(teeth^2 log teeth).
[[nodiscard]] std::vector<RevertedChoice> revertedChoices(const RevertedRequirements& requirements,
                                                          std::size_t most = 20);

/// A reverted train: input 1 and output 3 on one axis, countershaft 2; places are left open. The input turns
/// at 1 rad/s.
[[nodiscard]] Mechanism revertedTrain(const RevertedTeeth& teeth);

}  // namespace geargraph
