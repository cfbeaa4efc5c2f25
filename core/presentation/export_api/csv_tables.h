#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/foundations/files/csv.h"
#include "core/presentation/export_api/solved_statics.h"

namespace geargraph {

/// A table for export, with its name on the command line.
struct CsvTable {
  std::string_view name;
  std::string_view needs;  ///< what a mechanism needs for it, as part of a sentence
  /// Empty if the table is undefined for the mechanism.
  std::function<void(ByteSink&, const CsvOptions&)> write;
  bool ofLoads = false;  ///< it is not expected of a mechanism without loads
};

/// Every table of a snapshot; `solution` is defined only after analyzeFully(). The integer matrices; `screw`,
/// the screws (L M N P Q R) of Eq. (6) for each joint of each cycle; `p`, the coefficient matrix of Eqs.
/// (18), (19) in the document's unit; `solution`, Eq. (23), in decimals. Of statics, null where it is not
/// solved: `statics`, the balanced torques over the loaded ones, (23*); `cutset-equations`, (17*), a row for
/// each joint and a column for each mesh: P transposed; and the tables of force_table.h.
[[nodiscard]] std::vector<CsvTable> csvTables(const SnapshotPtr& snapshot, const SolvedStaticsPtr& statics);
/// The names of the tables that csvTables() returns, in their order.
[[nodiscard]] std::vector<std::string> csvTableNames();
/// Is the table with this name one of statics?
[[nodiscard]] bool isOfStatics(std::string_view name);
/// Is the table one of all states, rather than of one train?
[[nodiscard]] bool isOfAllStates(std::string_view name);

}  // namespace geargraph
