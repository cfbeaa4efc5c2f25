#pragma once

#include <string>
#include <vector>

#include "core/teaching/work_check/table_alignment.h"
#include "core/teaching/work_check/work_check.h"

namespace geargraph {

/// A matrix with a known mistake made throughout.
struct MistakenTable {
  std::string name;
  std::string reason;
  DerivedTable table;
};

/// All of them for a derived matrix, the most informative first. None equals the right one up to the freedom
/// of its rows.
[[nodiscard]] std::vector<MistakenTable> mistakenTables(const Vocabulary& vocabulary,
                                                        const DerivedTable& right);

/// The differences of rows and entries, by name. Each entry that differs is in one of them.
/// @pre the alignment has a derived row and column for each written one
[[nodiscard]] std::vector<WorkDifference> tableDifferences(const Vocabulary& vocabulary,
                                                           const DerivedTable& right,
                                                           const WrittenAmounts& written,
                                                           const Alignment& alignment);

/// The elements of an entry.
[[nodiscard]] std::vector<ElementId> elementsOf(const DerivedTable& table, int row, int column);

}  // namespace geargraph
