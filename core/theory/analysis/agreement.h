#pragma once

#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "core/theory/matroid/exact_solution.h"
#include "core/theory/ttgraph/tt_solution.h"

namespace geargraph {

/// Both methods' solutions side by side [AU, below Eq. (44): "the same as Eq. (25)"]. Compared by joint,
/// never by row: the paper itself exchanges two rows.
struct Agreement {
  bool equal = true;
  Rational largestDifference;  ///< of two entries that should be the same; with pi rounded
  long long compared = 0;      ///< entries
  std::vector<int> joints;     ///< whose rates differ, ascending
};

/// Compares two solutions. Solutions with different inputs or outputs, or with an undetermined matrix, do not
/// agree.
[[nodiscard]] Agreement agreementOf(const ExactSolution& matroid, const RateMatrix<Rational>& ttGraph);
[[nodiscard]] Agreement agreementOf(const PiSolution& matroid, const RateMatrix<PiNumber>& ttGraph);
/// Compares the rates of all joints, by joint, at the same input speeds.
[[nodiscard]] Agreement agreementOf(std::span<const Rational> matroid, std::span<const Rational> ttGraph);

/// Solves the T-T graph for the inputs of the matroid method's solution and compares exactly: the whole
/// matrices, or, where the solution omits its matrix because of its size, the rates at `speeds`.
///
/// std::nullopt if `stop` was requested. Cost: that of the T-T solution.
/// @pre graph.isComplete(); the solution is that of the same mechanism at these speeds, one per input
[[nodiscard]] std::optional<Agreement> agreementWith(const TtGraph& graph, const ExactSolution& matroid,
                                                     std::span<const Rational> speeds,
                                                     const std::stop_token& stop = {});

}  // namespace geargraph
