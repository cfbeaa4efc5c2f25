#pragma once

#include <cstdint>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/foundations/exact/elimination.h"
#include "core/foundations/exact/fields.h"

namespace geargraph::inline exact {

/// Most terms (numerator and denominator) of an expanded entry: more nobody reads, and a chain of planetary
/// stages of 40 links has 349,526.
constexpr int kExpansionBudget = 200;

/// Most factors and terms of all expanded entries of a solution together: of a deep train an entry is one
/// product with a factor for each carrier, and there are thousands of entries.
constexpr std::int64_t kSolutionBudget = 100'000;

/// How much may be expanded. `total` is what is left of it: expand() takes off what it has written, that of
/// entries which it gave up included, so that the budget bounds the work too.
struct ExpansionBudget {
  int terms = kExpansionBudget;  ///< of an entry
  std::int64_t total = kSolutionBudget;
};

/// Expands the solution of a symbolic system, line by line: every unknown as a function of the ratios alone.
///
/// `x` has a place for every column, 0 but for the given and the free ones, which are set. A place is none
/// where the entry went over the budget; its line then says it factored. `vanishing`, by column: known to be
/// identically zero (found by evaluation modulo a prime), so it stays 0. False where `stop` was requested.
/// Cost: O(lines), and the factors written, which the budget bounds.
[[nodiscard]] bool expand(const RationalFunctionField& field, const Elimination<RationalFunction>& system,
                          const std::vector<char>& vanishing, std::vector<std::optional<RationalFunction>>& x,
                          ExpansionBudget& budget, const std::stop_token& stop = {});

}  // namespace geargraph::inline exact
