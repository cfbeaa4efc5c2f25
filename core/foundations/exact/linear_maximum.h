#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/foundations/base/rational.h"

namespace geargraph {

/// One condition of a linear program: sum of coefficients * x is at most `bound`.
struct LinearBound {
  std::vector<Rational> coefficients;  ///< one for each unknown
  Rational bound;                      ///< 0 or above, so that x = 0 satisfies it
};

/// The greatest value of sum of objective * x over all x that satisfy the bounds, in fractions: the simplex
/// method by Bland's rule, which does not cycle (R. G. Bland, Math. Oper. Res. 2(2), 1977, 103-107).
/// std::nullopt if it grows without bound, or more than `mostPivots` pivots are needed.
/// Cost: bounds times unknowns for each pivot.
[[nodiscard]] std::optional<Rational> linearMaximum(std::span<const LinearBound> bounds,
                                                    std::span<const Rational> objective,
                                                    int mostPivots = 1000);

}  // namespace geargraph
