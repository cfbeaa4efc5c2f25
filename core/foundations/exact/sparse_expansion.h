#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <stop_token>
#include <utility>
#include <vector>

#include "core/foundations/exact/elimination.h"

namespace geargraph {

/// The non-zeros of a vector, by ascending position.
template <class Value>
using SparseVector = std::vector<std::pair<int, Value>>;

/// Computes sums of multiples of sparse vectors in one scratch array.
template <class Field>
class SparseSum {
 public:
  using Value = typename Field::Value;

  SparseSum(const Field& field, int places)
      : m_field(field),
        m_sum(static_cast<std::size_t>(places)),
        m_touched(static_cast<std::size_t>(places), 0) {}

  /// sum -= factor * vector
  void subtract(const Value& factor, const SparseVector<Value>& vector) {
    for (const auto& [place, value] : vector) m_field.subtractProduct(at(place), factor, value);
  }
  /// The element of the sum, 0 if untouched so far.
  Value& at(int place) {
    if (m_touched[place] == 0) {
      m_touched[place] = 1;
      m_places.push_back(place);
      m_sum[place] = m_field.fromInteger(0);
    }
    return m_sum[place];
  }
  /// Returns the sum divided by `divisor` and resets it to 0.
  [[nodiscard]] SparseVector<Value> take(const Value& divisor) {
    std::sort(m_places.begin(), m_places.end());
    SparseVector<Value> result;
    for (const int place : m_places) {
      m_touched[place] = 0;
      if (!m_field.isZero(m_sum[place])) result.emplace_back(place, m_field.quotient(m_sum[place], divisor));
    }
    m_places.clear();
    return result;
  }

 private:
  const Field& m_field;
  std::vector<Value> m_sum;
  std::vector<char> m_touched;
  std::vector<int> m_places;
};

/// Every unknown as a combination of the free and the given columns. std::nullopt if `stop` was requested or
/// there were more than `most` entries: then use substitute() for one column at a time. Cost: the entries,
/// times the length of a line.
template <class Field>
[[nodiscard]] std::optional<std::vector<SparseVector<typename Field::Value>>> expandSparse(
    const Field& field, const Elimination<typename Field::Value>& system, std::size_t most,
    const std::stop_token& stop = {}) {
  using Value = typename Field::Value;
  std::vector<SparseVector<Value>> x(static_cast<std::size_t>(system.columns));
  for (const int column : system.freeColumns) x[column].emplace_back(column, field.one());
  for (int column = system.unknowns; column < system.columns; ++column)
    x[column].emplace_back(column, field.one());
  SparseSum<Field> sum(field, system.columns);
  std::size_t entries = 0;
  for (const auto& line : system.lines) {
    if (stop.stop_requested()) return std::nullopt;
    const auto& rows = system.matrixOf(line.core);
    for (int entry = rows.begin(line.row); entry < rows.end(line.row); ++entry) {
      if (rows.column(entry) != line.column) sum.subtract(rows.value(entry), x[rows.column(entry)]);
    }
    x[line.column] = sum.take(pivotOf(rows, line.row, line.column));
    entries += x[line.column].size();
    if (entries > most) return std::nullopt;
  }
  return x;
}

}  // namespace geargraph
