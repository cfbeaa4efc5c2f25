#include "core/exact/peeling.h"

#include <algorithm>
#include <utility>

namespace geargraph {
namespace {

/// The work of the constructor. Of each row and column it keeps how many partners are left and the
/// exclusive-or of their numbers, which is the last partner's number once one is left.
class Peeler {
 public:
  Peeler(const SparsePattern& pattern, int unknowns, Peeling& result)
      : m_pattern(pattern),
        m_unknowns(unknowns),
        m_result(result),
        m_rows(static_cast<std::size_t>(pattern.rows())),
        m_columns(static_cast<std::size_t>(unknowns)),
        m_entries(pattern.columns.size()) {
    m_result.solved.assign(m_columns.size(), 0);
    m_result.first.reserve(std::min(m_rows.size(), m_columns.size()));
    for (int row = pattern.rows(); row-- > 0;) {  // so that a column has its rows in order
      Row& taking = m_rows[row];
      for (int entry = pattern.begin(row); entry < pattern.end(row); ++entry) {
        const int number = pattern.columns[entry];
        if (number >= unknowns) continue;
        Column& column = m_columns[number];
        ++taking.count;
        taking.key ^= number;
        ++column.count;
        column.key ^= row;
        m_entries[entry] = {row, std::exchange(column.first, entry)};
      }
    }
  }

  void run() {
    peelRows();
    peelColumns();
    for (int row = 0; row < m_pattern.rows(); ++row) {
      if (m_rows[row].gone) continue;
      (m_rows[row].count == 0 ? m_result.emptyRows : m_result.coreRows).push_back(row);
    }
  }

 private:
  struct Row {
    int count = 0;
    int key = 0;
    bool gone = false;
  };
  struct Column {
    int count = 0;
    int key = 0;
    int first = -1;  ///< of its entries
  };
  struct Entry {
    int row = 0;
    int next = -1;  ///< in its column
  };

  void peelRows() {
    m_queue.reserve(m_rows.size());
    for (int row = 0; row < m_pattern.rows(); ++row) {
      if (m_rows[row].count == 1) m_queue.push_back(row);
    }
    for (std::size_t at = 0; at < m_queue.size(); ++at) {
      const int row = m_queue[at];
      if (m_rows[row].count != 1) continue;  // another row was quicker
      const int column = m_rows[row].key;
      m_result.first.push_back({row, column});
      m_result.solved[column] = 1;
      m_rows[row].gone = true;
      for (int i = m_columns[column].first; i >= 0; i = m_entries[i].next) {
        Row& other = m_rows[m_entries[i].row];
        other.key ^= column;
        if (--other.count == 1) m_queue.push_back(m_entries[i].row);
      }
    }
  }

  void peelColumns() {
    m_queue.clear();
    for (int column = 0; column < m_unknowns; ++column) {
      if (m_columns[column].count == 1 && m_result.solved[column] == 0) m_queue.push_back(column);
    }
    for (std::size_t at = 0; at < m_queue.size(); ++at) {
      const int column = m_queue[at];
      if (m_columns[column].count != 1) continue;
      const int row = m_columns[column].key;
      m_result.last.push_back({row, column});
      m_result.solved[column] = 1;
      m_rows[row].gone = true;
      for (const int other : m_pattern.row(row)) {
        if (other >= m_unknowns || m_result.solved[other] != 0) continue;
        m_columns[other].key ^= row;
        if (--m_columns[other].count == 1) m_queue.push_back(other);
      }
      m_columns[column].count = 0;
    }
  }

  const SparsePattern& m_pattern;
  int m_unknowns;
  Peeling& m_result;
  std::vector<Row> m_rows;
  std::vector<Column> m_columns;
  std::vector<Entry> m_entries;  ///< of the pattern: each column's in a chain
  std::vector<int> m_queue;
};

}  // namespace

Peeling::Peeling(const SparsePattern& pattern, int unknowns) {
  Peeler(pattern, unknowns, *this).run();
}

}  // namespace geargraph
