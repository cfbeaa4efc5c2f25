#pragma once

#include <cstddef>
#include <stop_token>
#include <vector>

#include "core/foundations/exact/prime_field.h"

namespace geargraph {

using ResidueRow = std::vector<PrimeField::Residue>;

/// Brings the rows to reduced echelon form: pivots are 1 with zeros above them, columns from the left, rows
/// of zeros are dropped. Two sets of rows have the same form exactly if they span the same space. Returns the
/// columns of the pivots; incomplete if `stop` was requested. Cost: O(rows^2 columns).
std::vector<std::size_t> reduceRows(const PrimeField& field, std::vector<ResidueRow>& rows,
                                    const std::stop_token& stop = {});

}  // namespace geargraph
