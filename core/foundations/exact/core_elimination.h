#pragma once

#include <algorithm>
#include <memory_resource>
#include <set>
#include <span>
#include <stop_token>
#include <utility>
#include <vector>

#include "core/foundations/exact/peeling.h"
#include "core/foundations/exact/sparse_rows.h"

namespace geargraph {

/// Gaussian elimination of the rows left by peeling, sparsest pivots first (Markowitz). Used by eliminate().
///
/// 1. A row with one unknown solves it; in other rows the unknown is then kept like solved and given columns,
///    so that there is no fill-in.
/// 2. Else take a row with the fewest unknowns; among its acceptable pivots one with the shortest column.
///    Subtract the row from the other rows of that column.
/// 3. A row that loses its last unknown is empty; repeat until all rows are used or empty. (Rows that never
///    have an acceptable pivot count as empty too: at the ratios' own values they vanish.)
template <class Field>
class MarkowitzElimination {
 public:
  using Value = typename Field::Value;

  /// `solved`, by unknown: 1 for those solved by peeling.
  MarkowitzElimination(const Field& field, const SparseRows<Value>& matrix, std::span<const int> sources,
                       std::span<const char> solved, int columns)
      : m_field(field), m_rows(sources.size()), m_count(sources.size(), 0) {
    if (sources.empty()) return;
    m_active.assign(static_cast<std::size_t>(columns), 0);
    std::transform(solved.begin(), solved.end(), m_active.begin(), [](char s) { return s == 0 ? 1 : 0; });
    m_columnRows.resize(static_cast<std::size_t>(columns));
    m_place.assign(static_cast<std::size_t>(columns), -1);
    for (std::size_t row = 0; row < sources.size(); ++row) {
      const int source = sources[row];
      for (int entry = matrix.begin(source); entry < matrix.end(source); ++entry) {
        m_rows[row].push_back({matrix.column(entry), matrix.value(entry)});
        if (m_active[matrix.column(entry)] == 0) continue;
        ++m_count[row];
        m_columnRows[matrix.column(entry)].push_back(static_cast<int>(row));
      }
      m_waiting.emplace(m_count[row], static_cast<int>(row));
    }
  }

  /// False if `stop` was requested.
  [[nodiscard]] bool run(const std::stop_token& stop) {
    while (!m_waiting.empty()) {
      if (stop.stop_requested()) return false;
      const int row = m_waiting.begin()->second;
      if (m_count[row] == 0) {
        m_empty.push_back(row);
        m_waiting.erase(m_waiting.begin());
        continue;
      }
      pivot(row);
    }
    m_empty.insert(m_empty.end(), m_postponed.begin(), m_postponed.end());
    std::sort(m_empty.begin(), m_empty.end());
    return true;
  }

  [[nodiscard]] const std::vector<Pivot>& solved() const { return m_solved; }  ///< in order of solution
  [[nodiscard]] const std::vector<Pivot>& pivots() const { return m_pivots; }  ///< in order of elimination
  [[nodiscard]] const std::vector<int>& emptyRows() const { return m_empty; }
  [[nodiscard]] SparseRows<Value> takeRows(std::pmr::memory_resource* memory) {
    SparseRows<Value> result(memory);
    for (std::vector<Entry>& row : m_rows) {
      for (Entry& entry : row) result.add(entry.column, std::move(entry.value));
      result.endRow();
    }
    return result;
  }

 private:
  struct Entry {
    int column = 0;
    Value value;
  };

  /// An entry is an acceptable pivot if its weight is at least kFit of the largest of its row; among these
  /// the one with the shortest column. Entries of weight 0 are never pivots.
  [[nodiscard]] std::size_t choosePivot(const std::vector<Entry>& row) const {
    constexpr double kFit = 0.1;
    double heaviest = 0;
    for (const Entry& entry : row) {
      if (m_active[entry.column] != 0) heaviest = std::max(heaviest, m_field.pivotWeight(entry.value));
    }
    std::size_t best = row.size();
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (m_active[row[i].column] == 0) continue;
      const double weight = m_field.pivotWeight(row[i].value);
      if (weight == 0 || weight < kFit * heaviest) continue;
      if (best == row.size() || m_columnRows[row[i].column].size() < m_columnRows[row[best].column].size()) {
        best = i;
      }
    }
    return best;
  }

  void pivot(int row) {
    const std::size_t at = choosePivot(m_rows[row]);
    m_waiting.erase({m_count[row], row});
    if (at == m_rows[row].size()) {  // nothing fit yet; it is tried again after the next pivot
      m_postponed.push_back(row);
      return;
    }
    const int column = m_rows[row][at].column;
    const bool solves = m_count[row] == 1;
    (solves ? m_solved : m_pivots).push_back({row, column});
    std::vector<int> others = std::move(m_columnRows[column]);
    m_columnRows[column].clear();
    m_active[column] = 0;
    for (const Entry& entry : m_rows[row]) {
      if (m_active[entry.column] != 0) std::erase(m_columnRows[entry.column], row);
    }
    for (const int other : others) {
      if (other == row) continue;
      if (solves) {
        setCount(other, m_count[other] - 1);
      } else {
        subtract(row, at, other);
      }
    }
    for (const int waiting : m_postponed) m_waiting.emplace(m_count[waiting], waiting);
    m_postponed.clear();
  }

  /// other -= (its entry in the pivot's column / pivot) * row, without the pivot's column.
  void subtract(int row, std::size_t at, int other) {
    const std::vector<Entry>& from = m_rows[row];
    std::vector<Entry>& into = m_rows[other];
    const int column = from[at].column;
    const int countBefore = m_count[other];
    for (std::size_t i = 0; i < into.size(); ++i) m_place[into[i].column] = static_cast<int>(i);
    const Value factor = m_field.quotient(into[m_place[column]].value, from[at].value);
    for (std::size_t i = 0; i < from.size(); ++i) {
      if (i == at) continue;
      int& place = m_place[from[i].column];
      if (place < 0) {
        place = static_cast<int>(into.size());
        into.push_back({from[i].column, m_field.fromInteger(0)});
        if (m_active[from[i].column] != 0) {
          ++m_count[other];
          m_columnRows[from[i].column].push_back(other);
        }
      }
      m_field.subtractProduct(into[place].value, factor, from[i].value);
    }
    for (const Entry& entry : into) m_place[entry.column] = -1;
    dropZeros(into, column, other);
    const int count = m_count[other];
    m_count[other] = countBefore;
    setCount(other, count);
  }

  void setCount(int row, int count) {
    const bool waits = m_waiting.erase({m_count[row], row}) > 0;
    m_count[row] = count;
    if (waits) m_waiting.emplace(count, row);
  }

  void dropZeros(std::vector<Entry>& row, int pivotColumn, int number) {
    std::erase_if(row, [&](const Entry& entry) {
      if (entry.column == pivotColumn) {
        --m_count[number];
        return true;
      }
      if (!m_field.isZero(entry.value)) return false;
      if (m_active[entry.column] != 0) {
        --m_count[number];
        std::erase(m_columnRows[entry.column], number);
      }
      return true;
    });
  }

  const Field& m_field;
  std::vector<std::vector<Entry>> m_rows;
  std::vector<int> m_count;                    ///< by row: its unsolved unknowns
  std::vector<char> m_active;                  ///< by column: an unknown without a pivot
  std::vector<std::vector<int>> m_columnRows;  ///< by column: the waiting rows that have it
  std::vector<int> m_place;                    ///< by column: scratch of subtract(), -1 between calls
  std::set<std::pair<int, int>> m_waiting;     ///< (unknowns, row) of the rows not processed yet
  std::vector<int> m_postponed;
  std::vector<Pivot> m_solved;
  std::vector<Pivot> m_pivots;
  std::vector<int> m_empty;
};

}  // namespace geargraph
