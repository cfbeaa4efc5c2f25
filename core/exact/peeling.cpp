#include "core/exact/peeling.h"

namespace geargraph {
namespace {

/// The work of the constructor. Of each row and column it keeps how many partners are left and the
/// exclusive-or of their numbers, which is the last partner's number once one is left.
class Peeler {
 public:
  Peeler(const SparsePattern& pattern, int unknowns, Peeling& result)
      : m_pattern(pattern), m_unknowns(unknowns), m_result(result) {
    const auto rows = static_cast<std::size_t>(pattern.rows());
    const auto columns = static_cast<std::size_t>(unknowns);
    m_rowCount.assign(rows, 0);
    m_rowKey.assign(rows, 0);
    m_columnCount.assign(columns, 0);
    m_columnKey.assign(columns, 0);
    m_rowGone.assign(rows, 0);
    m_result.solved.assign(columns, 0);
    for (int row = 0; row < pattern.rows(); ++row) {
      for (const int column : pattern.row(row)) {
        if (column >= unknowns) continue;
        ++m_rowCount[row];
        m_rowKey[row] ^= column;
        ++m_columnCount[column];
        m_columnKey[column] ^= row;
      }
    }
    fillColumns();
  }

  void run() {
    peelRows();
    peelColumns();
    for (int row = 0; row < m_pattern.rows(); ++row) {
      if (m_rowGone[row] != 0) continue;
      (m_rowCount[row] == 0 ? m_result.emptyRows : m_result.coreRows).push_back(row);
    }
  }

 private:
  void fillColumns() {
    m_columnStart.assign(m_columnCount.size() + 1, 0);
    for (std::size_t i = 0; i < m_columnCount.size(); ++i) {
      m_columnStart[i + 1] = m_columnStart[i] + m_columnCount[i];
    }
    m_columnRows.resize(static_cast<std::size_t>(m_columnStart.back()));
    std::vector<int> next(m_columnStart.begin(), m_columnStart.end() - 1);
    for (int row = 0; row < m_pattern.rows(); ++row) {
      for (const int column : m_pattern.row(row)) {
        if (column < m_unknowns) m_columnRows[next[column]++] = row;
      }
    }
  }

  void peelRows() {
    std::vector<int> queue;
    for (int row = 0; row < m_pattern.rows(); ++row) {
      if (m_rowCount[row] == 1) queue.push_back(row);
    }
    for (std::size_t at = 0; at < queue.size(); ++at) {
      const int row = queue[at];
      if (m_rowCount[row] != 1) continue;  // another row was quicker
      const int column = m_rowKey[row];
      m_result.first.push_back({row, column});
      m_result.solved[column] = 1;
      m_rowGone[row] = 1;
      for (int i = m_columnStart[column]; i < m_columnStart[column + 1]; ++i) {
        const int other = m_columnRows[i];
        m_rowKey[other] ^= column;
        if (--m_rowCount[other] == 1) queue.push_back(other);
      }
    }
  }

  void peelColumns() {
    std::vector<int> queue;
    for (int column = 0; column < m_unknowns; ++column) {
      if (m_columnCount[column] == 1 && m_result.solved[column] == 0) queue.push_back(column);
    }
    for (std::size_t at = 0; at < queue.size(); ++at) {
      const int column = queue[at];
      if (m_columnCount[column] != 1) continue;
      const int row = m_columnKey[column];
      m_result.last.push_back({row, column});
      m_result.solved[column] = 1;
      m_rowGone[row] = 1;
      for (const int other : m_pattern.row(row)) {
        if (other >= m_unknowns || m_result.solved[other] != 0) continue;
        m_columnKey[other] ^= row;
        if (--m_columnCount[other] == 1) queue.push_back(other);
      }
      m_columnCount[column] = 0;
    }
  }

  const SparsePattern& m_pattern;
  int m_unknowns;
  Peeling& m_result;
  std::vector<int> m_rowCount;
  std::vector<int> m_rowKey;
  std::vector<int> m_columnCount;
  std::vector<int> m_columnKey;
  std::vector<int> m_columnStart;
  std::vector<int> m_columnRows;
  std::vector<char> m_rowGone;
};

}  // namespace

Peeling::Peeling(const SparsePattern& pattern, int unknowns) {
  Peeler(pattern, unknowns, *this).run();
}

}  // namespace geargraph
