#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/foundations/base/expected.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph::inline document_format {

/// How a table is written.
struct TableOptions {
  char separator = ',';        ///< ',' ';' or a tab
  bool byteOrderMark = false;  ///< EF BB BF, by which spreadsheet programs know UTF-8
};

/// The mechanism as a table (CSV, UTF-8): a header, then one row an element (`document`, `link`, `axis`,
/// `turningJoint`, `gearMesh`, `wheel`, `input`, `brake`, `clutch`, `state`, `load`, `balance`). Columns are
/// those that any element needs; resources/schema/README.md lists them. Numbers are spelled as in the
/// document, fractions included. Texts that spreadsheet programs would take for formulas get an apostrophe.
/// Cost: O(elements times columns).
[[nodiscard]] std::string writeMechanismTable(const Mechanism& mechanism, const TableOptions& options = {});

/// What a table holds of a mechanism, and in words what it does not: attached 3D files, the view, members
/// that this program does not know. No number of the analysis depends on these.
struct TablePart {
  Mechanism mechanism;
  std::vector<std::string> lost;
};
[[nodiscard]] TablePart tablePart(Mechanism mechanism);

/// Is this text a table rather than JSON? Decided by its first character.
[[nodiscard]] bool looksLikeTable(std::string_view bytes);

/// Reads such a table: any order of rows and columns, columns left out that no row needs; commas, semicolons
/// or tabs, and where these are no commas also decimal commas. Survives any bytes: the result is a mechanism
/// that can be saved and opened again, or what is wrong, with line and column: `syntax`; `format` (no column
/// `element`); else the first 100 of `schema` in the order of the rows; and if every row could be read, the
/// findings of wellFormedDiagnostics(). Beyond 64 MiB or 100,000 rows of a kind: `schema`.
///
/// Identity  readMechanismTable(writeMechanismTable(m)) is tablePart(m).mechanism.
/// Cost      O(bytes).
[[nodiscard]] Expected<Mechanism> readMechanismTable(std::string_view bytes);

/// The mechanism of a document or of a table, whichever it looks like.
[[nodiscard]] Expected<Mechanism> readMechanismOrTable(std::string_view bytes);

}  // namespace geargraph::inline document_format
