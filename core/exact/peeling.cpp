#include "core/exact/peeling.h"

#include <algorithm>

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
        m_columns(static_cast<std::size_t>(unknowns)) {
    m_result.solved.assign(m_columns.size(), 0);
    m_result.first.reserve(std::min(m_rows.size(), m_columns.size()));
    for (int row = 0; row < pattern.rows(); ++row) {
      for (const int column : pattern.row(row)) {
        if (column >= unknowns) continue;
        m_rows[row].take(column);
        m_columns[column].take(row);
      }
    }
    fillColumns();
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
    void take(int column) {
      ++count;
      key ^= column;
    }
  };
  struct Column {
    int count = 0;
    int key = 0;
    int begin = 0;  ///< of its rows in m_columnRows
    int end = 0;
    void take(int row) {
      ++count;
      key ^= row;
    }
  };

  void fillColumns() {
    int end = 0;
    for (Column& column : m_columns) {
      column.begin = column.end = end;
      end += column.count;
    }
    m_columnRows.resize(static_cast<std::size_t>(end));
    for (int row = 0; row < m_pattern.rows(); ++row) {
      for (const int column : m_pattern.row(row)) {
        if (column < m_unknowns) m_columnRows[m_columns[column].end++] = row;
      }
    }
  }

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
      for (int i = m_columns[column].begin; i < m_columns[column].end; ++i) {
        Row& other = m_rows[m_columnRows[i]];
        other.key ^= column;
        if (--other.count == 1) m_queue.push_back(m_columnRows[i]);
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
  std::vector<int> m_columnRows;
  std::vector<int> m_queue;
};

}  // namespace

Peeling::Peeling(const SparsePattern& pattern, int unknowns) {
  Peeler(pattern, unknowns, *this).run();
}

}  // namespace geargraph
