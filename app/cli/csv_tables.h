#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/foundations/files/csv.h"
#include "core/theory/analysis/analysis.h"

namespace geargraph::cli {

/// A table that can be exported, under its name on the command line.
struct CsvTable {
  std::string_view name;
  std::string_view needs;  ///< what a mechanism must have for it, for a sentence
  /// Nothing where the mechanism leaves the table undefined.
  std::function<void(ByteSink&, const CsvOptions&)> write;
};

/// Every table of a snapshot; `solution` is defined only after analyzeFully(). The integer matrices; `screw`,
/// the screws (L M N P Q R) of Eq. (6) for each joint of each cycle; `p`, the coefficient matrix of Eqs.
/// (18), (19) in the document's unit; `solution`, Eq. (23), in decimals.
[[nodiscard]] std::vector<CsvTable> csvTables(const SnapshotPtr& snapshot);

}  // namespace geargraph::cli
