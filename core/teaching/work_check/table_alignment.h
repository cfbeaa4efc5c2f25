#pragma once

#include <optional>
#include <stop_token>
#include <vector>

#include "core/teaching/work_check/derived_table.h"

namespace geargraph {

using WrittenAmounts = std::vector<std::vector<WrittenAmount>>;

/// The correspondence of written to derived rows and columns.
struct Alignment {
  std::vector<int> rows;     ///< by written row
  std::vector<int> columns;  ///< by written column
  std::vector<char> turned;  ///< by written row: it has the opposite sign, or is a multiple

  [[nodiscard]] bool isNatural() const;
};

/// The labels of a written table as positions in a derived one; none without labels.
struct LabelPositions {
  std::optional<std::vector<int>> rows;
  std::optional<std::vector<int>> columns;
};

/// What may be in another order without labels.
enum class FreeOrder { none, rows, columns, both };

/// The order in which the written entries equal the derived ones, the natural order first; std::nullopt if
/// there is none, or it was not found within 200,000 steps. Cost: rows times columns per step; a right matrix
/// in its natural order takes one step per row.
/// @pre both tables have one size
[[nodiscard]] std::optional<Alignment> alignmentOf(const Vocabulary& vocabulary,
                                                   const WrittenAmounts& written, const DerivedTable& derived,
                                                   RowFreedom freedom, const LabelPositions& labels,
                                                   FreeOrder order, const std::stop_token& stop = {});

/// The derived row scaled to the written one: by the factor, among those that the freedom allows, for which
/// the most entries agree. `columns` are those of the alignment.
/// Cost: for a multiple, the square of the number of non-zeros.
[[nodiscard]] std::vector<DerivedEntry> scaledRow(const Vocabulary& vocabulary,
                                                  const std::vector<WrittenAmount>& written,
                                                  const std::vector<DerivedEntry>& derived,
                                                  RowFreedom freedom, const std::vector<int>& columns);

}  // namespace geargraph
