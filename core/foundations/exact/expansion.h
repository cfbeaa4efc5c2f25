#pragma once

#include <cstdint>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/foundations/exact/elimination.h"
#include "core/foundations/exact/fields.h"

namespace geargraph {

/// The most terms (numerator and denominator) of an expanded entry: more would be unreadable, and a chain of
/// planetary stages with 40 links has 349,526.
constexpr int kExpansionBudget = 200;

/// The most factors and terms of all expanded entries of a solution together: in a deep train an entry is a
/// product with a factor for each carrier, and there are thousands of entries.
constexpr std::int64_t kSolutionBudget = 100'000;

/// The budget of an expansion. expand() subtracts from `total` what it has written, including entries that it
/// gave up, so that the budget also bounds the work.
struct ExpansionBudget {
  int terms = kExpansionBudget;  ///< of an entry
  std::int64_t total = kSolutionBudget;
};

/// Expands the solution of a symbolic system, line by line: every unknown as a function of the ratios alone.
///
/// `x` has an element for every column, 0 except for the given and the free ones, which are set. An element
/// becomes std::nullopt if it exceeded the budget; its line then still defines it in factored form.
/// `vanishing`, by column: known to be identically zero (found by evaluation modulo a prime), so it stays 0.
/// False if `stop` was requested.
/// Cost: O(lines), and the factors written, bounded by the budget.
[[nodiscard]] bool expand(const RationalFunctionField& field, const Elimination<RationalFunction>& system,
                          const std::vector<char>& vanishing, std::vector<std::optional<RationalFunction>>& x,
                          ExpansionBudget& budget, const std::stop_token& stop = {});

}  // namespace geargraph
