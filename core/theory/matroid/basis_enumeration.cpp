#include "core/theory/matroid/basis_enumeration.h"

#include <algorithm>

namespace geargraph {
namespace {

using Residue = PrimeField::Residue;

/// Rows from some element on, as they are once the chosen elements are contracted.
struct Rest {
  int first = 0;    ///< the element of row 0
  int columns = 0;  ///< the rank that is still to be chosen
  std::vector<Residue> values;

  [[nodiscard]] int rows() const { return columns == 0 ? 0 : static_cast<int>(values.size()) / columns; }
  [[nodiscard]] const Residue* row(int i) const {
    return values.data() + static_cast<std::ptrdiff_t>(i) * columns;
  }
};

class Lister {
 public:
  Lister(const PrimeField& field, std::size_t limit, const std::stop_token& stop)
      : m_field(field), m_limit(limit), m_stop(stop) {}

  void run(const Rest& rest) {
    if (rest.columns == 0) {
      m_sets.push_back(m_chosen);
      return;
    }
    const int last = lastStart(rest);
    for (int i = 0; i <= last && m_sets.size() < m_limit && hasBudget(); ++i) {
      const Residue* row = rest.row(i);
      const Residue* pivot = std::find_if(row, row + rest.columns, [](Residue value) { return value != 0; });
      if (pivot == row + rest.columns) continue;
      m_chosen.push_back(rest.first + i);
      run(contracted(rest, i, static_cast<int>(pivot - row)));
      m_chosen.pop_back();
    }
  }

  std::optional<std::vector<std::vector<int>>> take() {
    if (!hasBudget()) return std::nullopt;
    return std::move(m_sets);
  }

 private:
  [[nodiscard]] bool hasBudget() const { return m_steps > 0 && !m_stop.stop_requested(); }

  /// The last row from which on the rows still have full rank.
  [[nodiscard]] int lastStart(const Rest& rest) {
    std::vector<std::vector<Residue>> echelon(static_cast<std::size_t>(rest.columns));  // by leading column
    int missing = rest.columns;
    for (int i = rest.rows() - 1; i >= 0 && hasBudget(); --i) {
      std::vector<Residue> row(rest.row(i), rest.row(i) + rest.columns);
      for (int column = 0; column < rest.columns; ++column) {
        if (row[static_cast<std::size_t>(column)] == 0) continue;
        if (echelon[static_cast<std::size_t>(column)].empty()) {
          const Residue inverse = m_field.inverse(row[static_cast<std::size_t>(column)]);
          for (Residue& value : row) value = m_field.multiply(value, inverse);
          echelon[static_cast<std::size_t>(column)] = std::move(row);
          if (--missing == 0) return i;
          break;
        }
        const Residue factor = row[static_cast<std::size_t>(column)];
        m_steps -= rest.columns - column;
        for (int k = column; k < rest.columns; ++k) {
          row[k] = m_field.subtract(row[k],
                                    m_field.multiply(factor, echelon[static_cast<std::size_t>(column)][k]));
        }
      }
    }
    return -1;
  }

  /// The rows behind row i, modulo row i, without the column that it leads.
  [[nodiscard]] Rest contracted(const Rest& rest, int i, int pivot) {
    Rest result{rest.first + i + 1, rest.columns - 1, {}};
    if (result.columns == 0) return result;
    m_steps -= static_cast<long>(rest.rows() - i) * rest.columns;
    const Residue* by = rest.row(i);
    const Residue inverse = m_field.inverse(by[pivot]);
    result.values.reserve(static_cast<std::size_t>(rest.rows() - i - 1) *
                          static_cast<std::size_t>(result.columns));
    for (int k = i + 1; k < rest.rows(); ++k) {
      const Residue* row = rest.row(k);
      const Residue factor = m_field.multiply(row[pivot], inverse);
      for (int column = 0; column < rest.columns; ++column) {
        if (column == pivot) continue;
        result.values.push_back(
            factor == 0 ? row[column] : m_field.subtract(row[column], m_field.multiply(factor, by[column])));
      }
    }
    return result;
  }

  const PrimeField& m_field;
  std::size_t m_limit;
  std::stop_token m_stop;
  std::vector<int> m_chosen;
  std::vector<std::vector<int>> m_sets;
  long m_steps = 100'000'000;  ///< that are left
};

}  // namespace

std::optional<std::vector<std::vector<int>>> enumerateBases(
    const PrimeField& field, int rank, const std::vector<std::vector<std::pair<int, Residue>>>& rows,
    std::size_t limit, const std::stop_token& stop) {
  Rest all{0, rank, {}};
  all.values.assign(rows.size() * static_cast<std::size_t>(rank), 0);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (const auto& [column, value] : rows[i]) {
      all.values[i * static_cast<std::size_t>(rank) + static_cast<std::size_t>(column)] = value;
    }
  }
  Lister lister(field, limit, stop);
  lister.run(all);
  return lister.take();
}

}  // namespace geargraph
