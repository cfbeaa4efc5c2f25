#pragma once

#include <memory_resource>
#include <vector>

#include "core/foundations/exact/sparse_rows.h"

namespace geargraph {

/// An unknown and the equation that gives it.
struct Pivot {
  int row = 0;
  int column = 0;
};

/// The part of a homogeneous sparse system that can be solved without arithmetic. Columns below `unknowns`
/// are solved for, the others are given.
///
/// 1. A row with one unsolved unknown solves it (`first`, in order of solution). Repeat.
/// 2. A column in only one remaining row is solved by it at the end (`last`, in order of removal). Repeat.
///    Real trains are peeled nearly completely: the rest (`coreRows`) is small.
///
/// Cost: linear in the non-zeros.
struct SingletonElimination {
  std::pmr::vector<Pivot> first;
  std::pmr::vector<Pivot> last;
  std::pmr::vector<int> coreRows;   ///< in row order
  std::pmr::vector<int> emptyRows;  ///< rows whose unknowns were all solved by other rows
  std::pmr::vector<char> solved;    ///< by unknown: in `first` or `last`

  SingletonElimination(const SparsePattern& pattern, int unknowns);
};

}  // namespace geargraph
