#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory_resource>
#include <optional>
#include <span>
#include <stop_token>
#include <utility>
#include <vector>

#include "core/foundations/base/contract.h"
#include "core/foundations/exact/core_elimination.h"
#include "core/foundations/exact/peeling.h"
#include "core/foundations/exact/sparse_rows.h"

namespace geargraph {

/// A homogeneous sparse system A x = 0 in an order of substitution: every unknown follows from those before.
/// The unknowns are the columns 0 .. unknowns-1; the other columns are given (inputs, right-hand sides).
///
/// Identity  rank of A's unknown columns = rank(); unknowns = rank() + free columns; rows = lines + checks.
template <class Value>
struct Elimination {
  /// One unknown: pivot * x[column] + sum of the row's other entries * x = 0.
  struct Line {
    int column = 0;
    int row = 0;  ///< of `rows`, or of `coreRows`
    bool core = false;
  };
  /// A row without unknowns: 0 = 0 if its mesh is redundant, else a relation among given columns.
  struct Check {
    int source = 0;  ///< the row of A that it came from
    int row = 0;     ///< of `rows`, or of `coreRows`
    bool core = false;
  };

  SparseRows<Value> rows;      ///< A itself
  SparseRows<Value> coreRows;  ///< the rows left by peeling, after elimination
  int unknowns = 0;
  int columns = 0;
  std::pmr::vector<Line> lines;  ///< in order of substitution
  std::pmr::vector<Check> checks;
  std::pmr::vector<int> freeColumns;  ///< unknowns that no equation gives, ascending
  int coreSize = 0;                   ///< rows that needed arithmetic

  /// Uses the memory resource of the rows.
  Elimination(SparseRows<Value> system, int unknownCount, int columnCount)
      : rows(std::move(system)),
        coreRows(memory()),
        unknowns(unknownCount),
        columns(columnCount),
        lines(memory()),
        checks(memory()),
        freeColumns(memory()) {}
  Elimination() = default;  ///< an empty system

  [[nodiscard]] std::pmr::memory_resource* memory() const { return rows.pattern().memory(); }
  [[nodiscard]] int rank() const { return static_cast<int>(lines.size()); }
  [[nodiscard]] const SparseRows<Value>& matrixOf(bool core) const { return core ? coreRows : rows; }
};

/// Brings the system into that order: first rows and columns with one entry, which need no arithmetic, then
/// the rest with Markowitz pivots. std::nullopt if `stop` was requested.
///
/// Cost: linear in the non-zeros, and the elimination of the core, which is small for real trains.
/// @pre every column is below `columns`, unknowns <= columns; `peeling` is that of the rows' pattern
template <class Field>
[[nodiscard]] std::optional<Elimination<typename Field::Value>> eliminate(
    const Field& field, SparseRows<typename Field::Value> rows, SingletonElimination peeling, int unknowns,
    int columns, const std::stop_token& stop) {
  GEARGRAPH_REQUIRE(unknowns <= columns);
  using Value = typename Field::Value;
  Elimination<Value> result(std::move(rows), unknowns, columns);
  MarkowitzElimination<Field> core(field, result.rows, peeling.coreRows, peeling.solved, columns);
  if (!core.run(stop)) return std::nullopt;

  result.coreSize = static_cast<int>(peeling.coreRows.size());
  result.lines.reserve(peeling.solved.size());
  for (const Pivot& pivot : peeling.first) result.lines.push_back({pivot.column, pivot.row, false});
  for (const Pivot& pivot : core.solved()) {
    result.lines.push_back({pivot.column, pivot.row, true});
    peeling.solved[pivot.column] = 1;
  }
  for (auto pivot = core.pivots().rbegin(); pivot != core.pivots().rend(); ++pivot) {
    result.lines.push_back({pivot->column, pivot->row, true});
    peeling.solved[pivot->column] = 1;
  }
  for (auto pivot = peeling.last.rbegin(); pivot != peeling.last.rend(); ++pivot) {
    result.lines.push_back({pivot->column, pivot->row, false});
  }
  for (const int row : peeling.emptyRows) result.checks.push_back({row, row, false});
  for (const int row : core.emptyRows()) result.checks.push_back({peeling.coreRows[row], row, true});
  for (int column = 0; column < unknowns; ++column) {
    if (peeling.solved[column] == 0) result.freeColumns.push_back(column);
  }
  result.coreRows = core.takeRows(result.memory());
  return result;
}

template <class Field>
[[nodiscard]] std::optional<Elimination<typename Field::Value>> eliminate(
    const Field& field, SparseRows<typename Field::Value> rows, int unknowns, int columns,
    const std::stop_token& stop = {}) {
  SingletonElimination peeling(rows.pattern(), unknowns);
  return eliminate(field, std::move(rows), std::move(peeling), unknowns, columns, stop);
}

template <class Value>
[[nodiscard]] const Value& pivotOf(const SparseRows<Value>& rows, int row, int column) {
  int entry = rows.begin(row);
  while (rows.column(entry) != column) ++entry;
  return rows.value(entry);
}

/// Computes the unknowns of `Width` solutions, for substitute().
template <std::size_t Width, class Field>
void substituteSideBySide(const Field& field, const Elimination<typename Field::Value>& system,
                          typename Field::Value* x) {
  for (const auto& line : system.lines) {
    const auto& rows = system.matrixOf(line.core);
    std::array<typename Field::Sum, Width> sums{};
    const typename Field::Value* pivot = nullptr;
    for (int entry = rows.begin(line.row); entry < rows.end(line.row); ++entry) {
      const auto& value = rows.value(entry);
      if (rows.column(entry) == line.column) {
        pivot = &value;
        continue;
      }
      const auto* const known = x + static_cast<std::size_t>(rows.column(entry)) * Width;
      for (std::size_t k = 0; k < Width; ++k) field.subtractProduct(sums[k], value, known[k]);
    }
    const auto& divisor = field.divisor(*pivot);
    auto* const solved = x + static_cast<std::size_t>(line.column) * Width;
    for (std::size_t k = 0; k < Width; ++k) solved[k] = field.quotient(sums[k], divisor);
  }
}

constexpr std::size_t kMaxSideBySide = 4;

/// Computes the unknowns of `width` solutions at once, line by line: column j of solution k is x[j * width +
/// k]. @pre x has `width` elements for every column; the given and the free ones are set; width <=
/// kMaxSideBySide
/// Cost: the non-zeros of the lines, times the width.
template <class Field>
void substitute(const Field& field, const Elimination<typename Field::Value>& system,
                std::span<typename Field::Value> x, std::size_t width = 1) {
  GEARGRAPH_REQUIRE(x.size() >= static_cast<std::size_t>(system.columns) * width);
  switch (width) {
    case 1:
      return substituteSideBySide<1>(field, system, x.data());
    case 2:
      return substituteSideBySide<2>(field, system, x.data());
    case 3:
      return substituteSideBySide<3>(field, system, x.data());
    case kMaxSideBySide:
      return substituteSideBySide<kMaxSideBySide>(field, system, x.data());
    default:
      GEARGRAPH_REQUIRE(false);
  }
}

/// The sum of a row's entries times solution number `place` of x, negated.
template <class Field>
[[nodiscard]] typename Field::Value negatedRowSum(const Field& field,
                                                  const SparseRows<typename Field::Value>& rows, int row,
                                                  std::span<const typename Field::Value> x,
                                                  std::size_t width = 1, std::size_t place = 0) {
  typename Field::Value sum = field.fromInteger(0);
  for (int entry = rows.begin(row); entry < rows.end(row); ++entry) {
    const std::size_t at = static_cast<std::size_t>(rows.column(entry)) * width + place;
    field.subtractProduct(sum, rows.value(entry), x[at]);
  }
  return sum;
}

/// The (negated) value of a check row after substitute(): 0 if the row holds.
template <class Field>
[[nodiscard]] typename Field::Value checkValue(
    const Field& field, const Elimination<typename Field::Value>& system,
    const typename Elimination<typename Field::Value>::Check& check, std::span<const typename Field::Value> x,
    std::size_t width = 1, std::size_t place = 0) {
  return negatedRowSum(field, system.matrixOf(check.core), check.row, x, width, place);
}

}  // namespace geargraph
