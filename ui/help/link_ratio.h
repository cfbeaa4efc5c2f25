#pragma once

#include <optional>

#include "core/theory/analysis/analysis.h"

namespace geargraph {

/// The angular speed of one link as a multiple of that of another, both against the ground.
struct LinkRatio {
  enum class Kind {
    exact,        ///< in every motion
    now,          ///< at the given speeds of several inputs
    still,        ///< the second link stands still, so that there is none
    notParallel,  ///< about axes that are not parallel, or about several at once
    unsolved,     ///< there is no solution, or its exact part is not worked out
  };
  Kind kind = Kind::unsolved;
  Rational value;  ///< of exact and now; negative: against each other
};

/// The ratio of link `of` to link `to`, nodes of the snapshot's digraph. By the exact solution: coefficients
/// of the inputs decide whether it is the same in every motion, never a tolerance.
/// Cost: O(inputs · joints to the ground).
[[nodiscard]] LinkRatio linkRatio(const AnalysisSnapshot& snapshot, int of, int to);

}  // namespace geargraph
