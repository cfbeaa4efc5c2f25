#pragma once

#include <optional>
#include <stop_token>
#include <utility>
#include <vector>

#include "core/foundations/base/rational.h"
#include "core/foundations/exact/prime_field.h"

namespace geargraph {

/// The number of bases of the linear matroid of [I; A], I the unit rows of the rank, A these sparse rows.
/// Exact. `unitOrder`, `rowOrder`: positions of the unit rows and of the rows of A in one common order, in
/// which elements that share columns are close. std::nullopt if `stop` was requested or the work went over
/// the budget.
///
/// 1. Rows of A that are proportional, or that have one non-zero, are parallel elements: their weights add.
///    Columns likewise are series elements: weights w1 w2 / (w1 + w2), and the count is (w1 + w2) times the
///    rest's.
/// 2. The counts of independent components are multiplied.
/// 3. The rest is decided element by element (basis_sweep.h).
[[nodiscard]] std::optional<Rational> countBases(
    const PrimeField& field, const std::vector<int>& unitOrder,
    const std::vector<std::vector<std::pair<int, PrimeField::Residue>>>& rows,
    const std::vector<int>& rowOrder, const std::stop_token& stop);

}  // namespace geargraph
