#pragma once

#include <vector>

#include "core/mechanism/model/mechanism.h"

namespace geargraph::inline synthesis {

/// Two external pairs that lead back to the first axis: first with second, third with fourth, where second
/// and third are one shaft. Equal sums of teeth make both pairs one module.
struct RevertedTeeth {
  int first = 20;
  int second = 40;
  int third = 20;
  int fourth = 40;
  [[nodiscard]] Rational ratio() const { return Rational(second, first) * Rational(fourth, third); }
  friend bool operator==(const RevertedTeeth&, const RevertedTeeth&) = default;
};

struct RevertedWish {
  Rational ratio = 4;  ///< speed of drive over speed of driven, above 0
  int fewestTeeth = 17;
  int mostTeeth = 100;
};

struct RevertedChoice {
  RevertedTeeth teeth;
  Rational ratio;
  double error = 0;  ///< relative to the wish
};

/// Tooth counts within the limits, nearest to the wished ratio first, of equals the smallest first, one for
/// each ratio; `most` at most. The two pairs may be exchanged; only the one with the smaller first ratio is
/// named. Cost: O(teeth^2 log teeth).
[[nodiscard]] std::vector<RevertedChoice> revertedChoices(const RevertedWish& wish, std::size_t most = 20);

/// Input 1 and output 3 on one axis, countershaft 2; places left open. The input at 1 rad/s.
[[nodiscard]] Mechanism revertedTrain(const RevertedTeeth& teeth);

}  // namespace geargraph::inline synthesis
