#pragma once

#include <cstddef>
#include <memory_resource>
#include <span>
#include <utility>
#include <vector>

namespace geargraph {

/// The positions of the non-zeros of a matrix, row by row.
struct SparsePattern {
  std::pmr::vector<int> starts;   ///< by row, and one for the end
  std::pmr::vector<int> columns;  ///< of the entries, row by row; no column twice in a row

  explicit SparsePattern(std::pmr::memory_resource* memory = std::pmr::get_default_resource())
      : starts(1, 0, memory), columns(memory) {}

  /// The memory resource, also of eliminations of it.
  [[nodiscard]] std::pmr::memory_resource* memory() const { return columns.get_allocator().resource(); }
  [[nodiscard]] int rows() const { return static_cast<int>(starts.size()) - 1; }
  [[nodiscard]] int begin(int row) const { return starts[static_cast<std::size_t>(row)]; }
  [[nodiscard]] int end(int row) const { return starts[static_cast<std::size_t>(row) + 1]; }
  [[nodiscard]] std::span<const int> row(int row) const {
    return std::span(columns).subspan(static_cast<std::size_t>(begin(row)),
                                      static_cast<std::size_t>(end(row) - begin(row)));
  }
};

/// A sparse matrix by rows, filled from the top: add() the entries of a row, then endRow().
template <class Value>
class SparseRows {
 public:
  explicit SparseRows(std::pmr::memory_resource* memory = std::pmr::get_default_resource())
      : m_pattern(memory), m_values(memory) {}

  /// @pre the value is not 0 and the column not yet in this row
  void add(int column, Value value) {
    m_pattern.columns.push_back(column);
    m_values.push_back(std::move(value));
  }
  void endRow() { m_pattern.starts.push_back(static_cast<int>(m_pattern.columns.size())); }
  void reserve(std::size_t rows, std::size_t entries) {
    m_pattern.starts.reserve(rows + 1);
    m_pattern.columns.reserve(entries);
    m_values.reserve(entries);
  }

  [[nodiscard]] int rows() const { return m_pattern.rows(); }
  [[nodiscard]] const SparsePattern& pattern() const { return m_pattern; }
  /// Entries begin(row) .. end(row) - 1 are the row's.
  [[nodiscard]] int begin(int row) const { return m_pattern.begin(row); }
  [[nodiscard]] int end(int row) const { return m_pattern.end(row); }
  [[nodiscard]] int column(int entry) const { return m_pattern.columns[static_cast<std::size_t>(entry)]; }
  [[nodiscard]] const Value& value(int entry) const { return m_values[static_cast<std::size_t>(entry)]; }

 private:
  SparsePattern m_pattern;
  std::pmr::vector<Value> m_values;
};

}  // namespace geargraph
