#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/foundations/base/expected.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph {

/// How a table is written.
struct TableOptions {
  char separator = ',';        ///< ',' ';' or a tab
  bool byteOrderMark = false;  ///< EF BB BF, by which spreadsheet programs recognise UTF-8
};

/// The mechanism as a table (CSV, UTF-8): a header, then one row per element (`document`, `link`, `axis`,
/// `turningJoint`, `gearMesh`, `wheel`, `input`, `brake`, `clutch`, `state`, `load`, `balance`). Columns are
/// those that any element needs; resources/schema/README.md lists them. Numbers are spelled as in the
/// document, fractions included. Texts that spreadsheet programs would take for formulas get an apostrophe.
/// Cost: O(elements times columns).
[[nodiscard]] std::string writeMechanismTable(const Mechanism& mechanism, const TableOptions& options = {});

/// The part of a mechanism that a table can hold, and descriptions of what is lost: attached 3D files, the
/// view, unknown members. No number of the analysis depends on these.
struct TablePart {
  Mechanism mechanism;
  std::vector<std::string> lost;
};
[[nodiscard]] TablePart tablePart(Mechanism mechanism);

/// Is this text a table rather than JSON? Decided by its first character.
[[nodiscard]] bool looksLikeTable(std::string_view bytes);

/// Reads such a table: rows and columns in any order, unused columns may be missing; separated by commas,
/// semicolons or tabs, the latter two also with decimal commas. Accepts any bytes: the result is a mechanism
/// that can be saved and opened again, or what is wrong, with line and column: `syntax`; `format` (no column
/// `element`); else the first 100 of `schema` in the order of the rows; and if every row could be read, those
/// of wellFormedDiagnostics(). Beyond 64 MiB or 100,000 rows of a kind: `schema`.
///
/// Identity  readMechanismTable(writeMechanismTable(m)) is tablePart(m).mechanism.
/// Cost      O(bytes).
[[nodiscard]] Expected<Mechanism> readMechanismTable(std::string_view bytes);

/// Reads a document or a table, decided by looksLikeTable().
[[nodiscard]] Expected<Mechanism> readMechanismOrTable(std::string_view bytes);

}  // namespace geargraph
