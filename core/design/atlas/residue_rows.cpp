#include "core/design/atlas/residue_rows.h"

#include <algorithm>

namespace geargraph {

std::vector<std::size_t> reduceRows(const PrimeField& field, std::vector<ResidueRow>& rows,
                                    const std::stop_token& stop) {
  const std::size_t columns = rows.empty() ? 0 : rows.front().size();
  std::vector<std::size_t> pivots;
  for (std::size_t column = 0; column < columns && pivots.size() < rows.size(); ++column) {
    if (stop.stop_requested()) break;
    const std::size_t rank = pivots.size();
    const auto found = std::find_if(rows.begin() + static_cast<std::ptrdiff_t>(rank), rows.end(),
                                    [&](const ResidueRow& row) { return row[column] != 0; });
    if (found == rows.end()) continue;
    std::swap(*found, rows[rank]);
    const PrimeField::Residue inverse = field.inverse(rows[rank][column]);
    for (PrimeField::Residue& entry : rows[rank]) entry = field.multiply(entry, inverse);
    for (std::size_t r = 0; r < rows.size(); ++r) {
      const PrimeField::Residue factor = rows[r][column];
      if (r == rank || factor == 0) continue;
      for (std::size_t c = column; c < columns; ++c)
        rows[r][c] = field.subtract(rows[r][c], field.multiply(factor, rows[rank][c]));
    }
    pivots.push_back(column);
  }
  rows.resize(pivots.size());
  return pivots;
}

}  // namespace geargraph
