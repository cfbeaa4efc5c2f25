#include "core/foundations/exact/peeling.h"

#include <algorithm>

namespace geargraph {
namespace {

/// The work of the constructor. Of each row, and of each column that rows leave over, it keeps how many
/// partners are left and the exclusive-or of their numbers, which is the last partner's number once one is
/// left.
class Peeler {
 public:
  Peeler(const SparsePattern& pattern, int unknowns, SingletonElimination& result)
      : m_pattern(pattern),
        m_unknowns(unknowns),
        m_result(result),
        m_rows(static_cast<std::size_t>(pattern.rows()), pattern.memory()),
        m_starts(static_cast<std::size_t>(unknowns) + 1, 0, pattern.memory()),
        m_around(pattern.memory()),
        m_queue(pattern.memory()) {
    m_result.solved.assign(static_cast<std::size_t>(unknowns), 0);
    m_result.first.reserve(static_cast<std::size_t>(std::min(pattern.rows(), unknowns)));
    m_queue.reserve(m_rows.size());
    count();
    indexColumns();
  }

  void run() {
    peelRows();
    if (anyRowLeft()) peelColumns();
    for (int row = 0; row < m_pattern.rows(); ++row) {
      if (m_rows[row].count == kGone) continue;
      (m_rows[row].count == 0 ? m_result.emptyRows : m_result.coreRows).push_back(row);
    }
  }

 private:
  static constexpr int kGone = -1;  ///< count of a row that solves an unknown

  struct Partners {
    int count = 0;
    int key = 0;
  };

  /// The rows' partners, and for each column how often it stands in rows; the rows to start with.
  void count() {
    for (int row = 0; row < m_pattern.rows(); ++row) {
      Partners partners;
      for (const int column : m_pattern.row(row)) {
        if (column >= m_unknowns) continue;
        ++partners.count;
        partners.key ^= column;
        ++m_starts[column];
      }
      m_rows[row] = partners;
      if (partners.count == 1) m_queue.push_back(row);
    }
  }

  /// Counting sort: each column's places are filled from their end, so that its rows stand in order.
  void indexColumns() {
    int end = 0;
    for (int& start : m_starts) end = start += end;
    m_around.resize(static_cast<std::size_t>(end));
    for (int row = m_pattern.rows(); row-- > 0;) {
      for (const int column : m_pattern.row(row)) {
        if (column < m_unknowns) m_around[--m_starts[column]] = row;
      }
    }
  }

  void peelRows() {
    for (std::size_t at = 0; at < m_queue.size(); ++at) {
      const int row = m_queue[at];
      if (m_rows[row].count != 1) continue;  // another row was quicker
      const int column = m_rows[row].key;
      m_result.first.push_back({row, column});
      m_result.solved[column] = 1;
      for (int i = m_starts[column]; i < m_starts[column + 1]; ++i) {
        Partners& other = m_rows[m_around[i]];
        other.key ^= column;
        if (--other.count == 1) m_queue.push_back(m_around[i]);
      }
      m_rows[row].count = kGone;
    }
  }

  [[nodiscard]] bool anyRowLeft() const {
    return std::any_of(m_rows.begin(), m_rows.end(), [](const Partners& row) { return row.count > 0; });
  }

  void peelColumns() {
    std::pmr::vector<Partners> columns(static_cast<std::size_t>(m_unknowns), m_pattern.memory());
    for (int row = 0; row < m_pattern.rows(); ++row) {
      if (m_rows[row].count <= 0) continue;
      for (const int column : m_pattern.row(row)) {
        if (column >= m_unknowns || m_result.solved[column] != 0) continue;
        ++columns[column].count;
        columns[column].key ^= row;
      }
    }
    m_queue.clear();
    for (int column = 0; column < m_unknowns; ++column) {
      if (columns[column].count == 1) m_queue.push_back(column);
    }
    for (std::size_t at = 0; at < m_queue.size(); ++at) {
      const int column = m_queue[at];
      if (columns[column].count != 1) continue;
      const int row = columns[column].key;
      m_result.last.push_back({row, column});
      m_result.solved[column] = 1;
      m_rows[row].count = kGone;
      for (const int other : m_pattern.row(row)) {
        if (other >= m_unknowns || m_result.solved[other] != 0) continue;
        columns[other].key ^= row;
        if (--columns[other].count == 1) m_queue.push_back(other);
      }
      columns[column].count = 0;
    }
  }

  const SparsePattern& m_pattern;
  int m_unknowns;
  SingletonElimination& m_result;
  std::pmr::vector<Partners> m_rows;
  std::pmr::vector<int> m_starts;  ///< by column, and one behind: where its rows begin in m_around
  std::pmr::vector<int> m_around;
  std::pmr::vector<int> m_queue;
};

}  // namespace

SingletonElimination::SingletonElimination(const SparsePattern& pattern, int unknowns)
    : first(pattern.memory()),
      last(pattern.memory()),
      coreRows(pattern.memory()),
      emptyRows(pattern.memory()),
      solved(pattern.memory()) {
  Peeler(pattern, unknowns, *this).run();
}

}  // namespace geargraph
