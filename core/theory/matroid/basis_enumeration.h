#pragma once

#include <cstddef>
#include <optional>
#include <stop_token>
#include <utility>
#include <vector>

#include "core/foundations/exact/prime_field.h"

namespace geargraph {

/// The bases of the linear matroid of these sparse rows of length `rank`, in lexicographic order, `limit` at
/// most.
/// std::nullopt if `stop` was requested or the work exceeded its budget of some 100 million steps.
/// Cost: a dense elimination for each node of the search tree; every branch ends in a basis.
/// @pre the rows have that rank
[[nodiscard]] std::optional<std::vector<std::vector<int>>> enumerateBases(
    const PrimeField& field, int rank,
    const std::vector<std::vector<std::pair<int, PrimeField::Residue>>>& rows, std::size_t limit,
    const std::stop_token& stop);

}  // namespace geargraph
