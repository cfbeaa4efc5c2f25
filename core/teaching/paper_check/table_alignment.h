#pragma once

#include <optional>
#include <stop_token>
#include <vector>

#include "core/teaching/paper_check/derived_table.h"

namespace geargraph::inline paper_check {

using WrittenAmounts = std::vector<std::vector<WrittenAmount>>;

/// Which derived row and column each written one is.
struct Alignment {
  std::vector<int> rows;     ///< by written row
  std::vector<int> columns;  ///< by written column
  std::vector<char> turned;  ///< by written row: its sign is the other one, or it is a multiple

  [[nodiscard]] bool isNatural() const;
};

/// The labels of a written table as positions of a derived one; nothing where there are none.
struct LabelPlaces {
  std::optional<std::vector<int>> rows;
  std::optional<std::vector<int>> columns;
};

/// What may be in another order where no labels say it.
enum class FreeOrder { none, rows, columns, both };

/// The order in which the written entries are the derived ones, the natural order first; nothing where there
/// is none, or it was not found within 200,000 steps.
/// Cost: rows times columns for each step; a right matrix in its natural order takes as many steps as rows.
/// @pre of one size
[[nodiscard]] std::optional<Alignment> alignmentOf(const Vocabulary& vocabulary,
                                                   const WrittenAmounts& written, const DerivedTable& derived,
                                                   RowFreedom freedom, const LabelPlaces& labels,
                                                   FreeOrder order, const std::stop_token& stop = {});

/// What the derived row would have to read like for the written one to be right: scaled by the factor that
/// makes the most entries agree, of those that the freedom allows. `columns` are those of the alignment.
/// Cost: the square of the entries that are not 0, for a multiple.
[[nodiscard]] std::vector<DerivedEntry> scaledRow(const Vocabulary& vocabulary,
                                                  const std::vector<WrittenAmount>& written,
                                                  const std::vector<DerivedEntry>& derived,
                                                  RowFreedom freedom, const std::vector<int>& columns);

}  // namespace geargraph::inline paper_check
