#include "core/teaching/exercises/rate_system.h"

#include <algorithm>

#include "core/foundations/base/ordinal.h"

namespace geargraph {

std::optional<std::vector<Rational>> ratesFrom(std::vector<std::vector<Rational>> rows,
                                               std::span<const std::pair<int, Rational>> inputs) {
  if (rows.empty()) return std::nullopt;
  const std::size_t width = rows.front().size();
  for (std::vector<Rational>& row : rows) row.emplace_back(0);
  for (const auto& [joint, rate] : inputs) {
    ByJoint<Rational> row(width + 1);
    row[joint] = 1;
    row[width] = rate;
    rows.push_back(std::move(row));
  }
  std::size_t rank = 0;
  for (std::size_t column = 0; column < width; ++column) {
    const auto pivot = std::find_if(rows.begin() + static_cast<std::ptrdiff_t>(rank), rows.end(),
                                    [&](const std::vector<Rational>& row) { return !row[column].isZero(); });
    if (pivot == rows.end()) return std::nullopt;
    std::iter_swap(rows.begin() + static_cast<std::ptrdiff_t>(rank), pivot);
    const Rational inverse = rows[rank][column].inverse();
    for (std::size_t i = column; i <= width; ++i) rows[rank][i] *= inverse;
    for (std::size_t other = 0; other < rows.size(); ++other) {
      const Rational factor = rows[other][column];
      if (other == rank || factor.isZero()) continue;
      for (std::size_t i = column; i <= width; ++i) {
        if (!rows[rank][i].isZero()) rows[other][i] -= factor * rows[rank][i];
      }
    }
    ++rank;
  }
  std::vector<Rational> rates;
  for (std::size_t i = 0; i < width; ++i) rates.push_back(rows[i][width]);
  const bool isConsistent =
      std::all_of(rows.begin() + static_cast<std::ptrdiff_t>(rank), rows.end(),
                  [&](const std::vector<Rational>& row) { return row[width].isZero(); });
  if (!isConsistent) return std::nullopt;
  return rates;
}

}  // namespace geargraph
