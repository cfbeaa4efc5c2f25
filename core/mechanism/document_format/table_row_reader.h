#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/foundations/base/diagnostic.h"
#include "core/foundations/base/translation.h"
#include "core/foundations/files/csv_records.h"
#include "core/mechanism/model/mechanism.h"
#include "core/mechanism/model/member_info.h"

namespace geargraph {

/// Collects at most kMax diagnostics about a table, so that a malicious file cannot exhaust the memory.
class TableDiagnostics {
 public:
  static constexpr std::size_t kMax = 100;

  void add(Code code, std::string message, std::vector<ElementId> elements, int line, int column);
  [[nodiscard]] bool isFull() const { return m_found.size() >= kMax; }
  [[nodiscard]] bool empty() const { return m_found.empty(); }
  /// All diagnostics, with a last one if more were dropped.
  [[nodiscard]] Diagnostics all() const;

 private:
  Diagnostics m_found;
  bool m_hasMore = false;
};

/// Which column is at which position of a record.
using TableHeader = std::map<std::string_view, std::size_t>;

struct ActionCells;  // table_columns.h

/// Reads the cells of one row into an element (table_columns.h). A cell that cannot be read adds a diagnostic
/// and leaves the default.
class TableRowReader {
 public:
  static constexpr bool kReads = true;

  /// @pre all of them outlive the reader
  TableRowReader(const TableHeader& header, const std::vector<CsvField>& fields, bool hasDecimalComma,
                 TableDiagnostics& diagnostics);

  void text(std::string_view column, std::string& text);
  template <class Tag>
  void id(std::string_view column, Id<Tag>& id);
  template <class Tag>
  void id(std::string_view column, std::optional<Id<Tag>>& id);
  template <class Tag>
  void ids(std::string_view column, std::vector<Id<Tag>>& ids);
  void number(std::string_view column, std::optional<Number>& number);
  void numberOrZero(std::string_view column, Number& number);
  void requiredNumber(std::string_view column, Number& number);
  template <std::size_t count>
  void numbers(const std::array<std::string_view, count>& columns,
               std::optional<std::array<Number, count>>& numbers);
  void teeth(std::string_view column, int& teeth);
  void meshKind(std::string_view column, std::optional<MeshKind>& kind);
  void hand(std::string_view column, std::optional<Hand>& hand);
  void jointKind(std::string_view column, JointKind& kind);
  void sharing(std::string_view column, std::optional<LoadSharing>& sharing);
  void flag(std::string_view column, bool& flag);
  /// What a load does, and where a balance acts: several cells together.
  void action(const std::array<MemberInfo, 6>& infos, decltype(Load::action)& action);
  void action(const std::array<MemberInfo, 3>& infos, decltype(HoldingTorque::at)& at);

  /// From here on, diagnostics name the element of the column "id".
  template <class ElementsId>
  void blameId() {
    if (const std::string id = shortId(); !id.empty()) m_blamed = {ElementsId(id)};
  }
  /// Adds a diagnostic at a column, or at the row if the table has no such column.
  void wrong(std::string_view column, std::string message);
  /// Adds a diagnostic about the row as a whole; then its cells need none.
  void wrongRow(std::string message);
  /// Adds a diagnostic for every non-empty cell that was not read and would be lost.
  void rejectOtherCells(std::string_view element);
  /// Is any cell but `element` non-empty?
  [[nodiscard]] bool hasCells() const;

 private:
  /// The text of a cell; empty where there is none.
  [[nodiscard]] const std::string& cell(std::string_view column);
  void missing(std::string_view column, std::string_view expected);
  /// False, with a diagnostic, unless the cells name a joint or a link, and an axis beside a link only.
  [[nodiscard]] bool namesPlace(const ActionCells& cells);
  /// `expected` is marked by toTranslate().
  void unexpected(std::string_view column, std::string_view expected);
  /// The id in the column "id"; empty if there is no valid one.
  [[nodiscard]] std::string shortId();
  [[nodiscard]] std::optional<InternedString> atom(std::string_view column);

  const TableHeader& m_header;
  const std::vector<CsvField>& m_fields;
  bool m_hasDecimalComma;
  TableDiagnostics& m_diagnostics;
  std::vector<ElementId> m_blamed;
  std::vector<bool> m_isRead;  ///< by position
};

template <class Tag>
void TableRowReader::id(std::string_view column, Id<Tag>& id) {
  if (const auto read = atom(column)) {
    id = Id<Tag>(*read);
  } else if (cell(column).empty()) {
    missing(column, toTranslate("an id"));
  }
}

template <class Tag>
void TableRowReader::id(std::string_view column, std::optional<Id<Tag>>& id) {
  if (const auto read = atom(column)) id = Id<Tag>(*read);
}

template <std::size_t count>
void TableRowReader::numbers(const std::array<std::string_view, count>& columns,
                             std::optional<std::array<Number, count>>& numbers) {
  std::array<Number, count> read;
  std::size_t given = 0;
  std::string_view empty;
  for (std::size_t i = 0; i < count; ++i) {
    std::optional<Number> one;
    number(columns.at(i), one);
    if (cell(columns.at(i)).empty()) {
      empty = columns.at(i);
    } else {
      ++given;
    }
    if (one) read.at(i) = *one;
  }
  if (given == 0) return;
  if (given < count) return missing(empty, toTranslate("a number, as its neighbours have one"));
  numbers = std::move(read);
}

}  // namespace geargraph
