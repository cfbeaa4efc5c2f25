#pragma once

#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "core/theory/matroid/exact_solution.h"
#include "core/theory/ttgraph/tt_solution.h"

namespace geargraph::inline analysis {

/// Both methods' solutions side by side [AU, below Eq. (44): "the same as Eq. (25)"]. Compared by joint,
/// never by row: the paper itself exchanges two rows.
struct Agreement {
  bool equal = true;
  Rational largestDifference;  ///< of two entries that should be the same
  long long compared = 0;      ///< entries
  std::vector<int> joints;     ///< whose rates differ, ascending
};

/// Of two solutions that are there. Different inputs or outputs do not agree, nor does a matrix that is not
/// determined.
[[nodiscard]] Agreement agreementOf(const ExactSolution& matroid, const RateMatrix<Rational>& ttGraph);
/// Of the rates of all joints, by joint, at the same input speeds.
[[nodiscard]] Agreement agreementOf(std::span<const Rational> matroid, std::span<const Rational> ttGraph);

/// Solves the T-T graph for the inputs of the matroid method's solution and compares exactly: the whole
/// matrices, or where the solution leaves its matrix out for its size, the rates at its speeds.
///
/// None where `stop` was requested. Cost: that of the T-T solution.
/// @pre graph.isComplete(); the solution is the same mechanism's, found at these speeds
[[nodiscard]] std::optional<Agreement> agreementWith(const TtGraph& graph, const ExactSolution& matroid,
                                                     std::span<const Rational> speeds,
                                                     const std::stop_token& stop = {});

}  // namespace geargraph::inline analysis
