// Reads a table of a mechanism: the header, a row at a time, then what the rows mean together.

#include <algorithm>
#include <charconv>
#include <unordered_map>

#include "core/foundations/base/text_lists.h"
#include "core/foundations/base/translation.h"
#include "core/foundations/files/csv_records.h"
#include "core/mechanism/document_format/mechanism_file.h"
#include "core/mechanism/document_format/mechanism_table.h"
#include "core/mechanism/document_format/table_columns.h"
#include "core/mechanism/document_format/table_row_reader.h"
#include "core/mechanism/model/limits.h"
#include "core/mechanism/model/validate.h"

namespace geargraph {
namespace {

/// The steps of a JSON pointer to a member of a document: {"axes", "3", "point", "0"}.
std::vector<std::string_view> stepsOf(std::string_view pointer) {
  std::vector<std::string_view> steps;
  while (!pointer.empty()) {
    const std::size_t end = std::min(pointer.find('/', 1), pointer.size());
    steps.push_back(pointer.substr(1, end - 1));
    pointer.remove_prefix(end);
  }
  return steps;
}

std::size_t positionOf(std::string_view step) {
  std::size_t position = 0;
  std::from_chars(step.data(), step.data() + step.size(), position);
  return position;
}

/// The column of a member of the document; of a list of numbers, that of the one at `position`.
std::string_view columnOf(std::string_view member, std::size_t position) {
  const auto at = [&](const auto& columns) { return columns.at(std::min(position, columns.size() - 1)); };
  for (const DocumentPart part : documentParts()) {
    const MemberInfo* const info = memberOf(part, member);
    if (info == nullptr) continue;
    if (info->value == MemberValue::triple) return at(tripleColumns(*info));
    if (info->value == MemberValue::inertia) return at(kInertiaColumns);
    if (info->value == MemberValue::ends) return kLowLimit;
    const bool isClutch = info->value == MemberValue::references && part == DocumentPart::coupling;
    if (isClutch) return position == 0 ? "tail" : "head";
  }
  return member;
}

/// What rows are about: the words of the column "element".
std::vector<std::string> rowNames() {
  std::vector<std::string> names{std::string(Description<Mechanism>::name)};
  const auto add = [&]<class Element>(const Element* /*none*/) {
    if constexpr (std::is_same_v<Element, ShiftElement>) {
      names.insert(names.end(), {"brake", "clutch"});
    } else {
      names.emplace_back(Description<Element>::name);
    }
  };
  forEachField<Mechanism>([&]<class Member>(const Member& /*field*/) {
    using Value = typename Member::Value;
    if constexpr (DescribedList<Value>) {
      add(static_cast<const typename ElementOfList<Value>::Type*>(nullptr));
    } else if constexpr (requires { typename ElementOfList<typename Value::value_type>::Type; }) {
      add(static_cast<const typename ElementOfList<typename Value::value_type>::Type*>(nullptr));
    }
  });
  return names;
}

class TableReader {
 public:
  explicit TableReader(std::string_view bytes)
      : m_separator(csvSeparatorOf(bytes)), m_records(bytes, m_separator) {}

  Expected<Mechanism> run() {
    if (!readHeader()) return m_diagnostics.all();
    while (!m_diagnostics.isFull() && !m_isBeyondLimits && m_records.next(m_fields)) readRow();
    if (const auto& error = m_records.error())
      m_diagnostics.add(error->code, error->message, {}, error->line, error->column);
    if (m_diagnostics.empty()) addSemanticDiagnostics();
    if (!m_diagnostics.empty()) return m_diagnostics.all();
    return std::move(m_mechanism);
  }

 private:
  bool readHeader() {
    const bool isRead = m_records.next(m_fields);
    if (const auto& error = m_records.error()) {
      m_diagnostics.add(error->code, error->message, {}, error->line, error->column);
      return false;
    }
    const auto named = [](const CsvField& field) { return field.text == "element"; };
    if (!isRead || std::none_of(m_fields.begin(), m_fields.end(), named)) {
      m_diagnostics.add(Code::format,
                        translated("This is no table of a mechanism: its first row has to name the columns, "
                                   "\"element\" among them."),
                        {}, 1, 1);
      return false;
    }
    for (std::size_t i = 0; i < m_fields.size(); ++i) readColumn(i);
    if (m_records.count() > m_fields.size())
      m_diagnostics.add(Code::schema, translated("There are too many columns."), {}, m_fields.back().line,
                        m_fields.back().column);
    return m_diagnostics.empty();
  }

  void readColumn(std::size_t position) {
    const CsvField& field = m_fields[position];
    if (field.text.empty()) return;  // its cells have to be empty, too
    const auto known = std::find(kTableColumns.begin(), kTableColumns.end(), field.text);
    if (known == kTableColumns.end()) {
      std::vector<std::string> names(kTableColumns.begin(), kTableColumns.end());
      m_diagnostics.add(
          Code::schema,
          translated("There is no column \"%1\": %2.",
                     {field.text.substr(0, kMaxNameLength), listed(names, kAllNames, toTranslate("or"))}),
          {}, field.line, field.column);
    } else if (!m_header.emplace(*known, position).second) {
      m_diagnostics.add(Code::schema, translated("The column \"%1\" occurs twice.", {field.text}), {},
                        field.line, field.column);
    }
  }

  void readRow() {
    const auto isEmpty = [](const CsvField& field) { return field.text.empty(); };
    if (std::all_of(m_fields.begin(), m_fields.end(), isEmpty)) return;
    if (!hasOnlyNamedCells()) return;
    TableRowReader row(m_header, m_fields, m_separator != ',', m_diagnostics);
    const std::size_t at = m_header.at("element");
    const std::string element = at < m_fields.size() ? m_fields[at].text : "";
    if (!readElement(element, row)) {
      row.wrong("element", element.empty()
                               ? translated("The column \"element\" is empty; it says what the row is about.")
                               : translated("There is no element \"%1\": %2.",
                                            {element.substr(0, kMaxNameLength),
                                             listed(rowNames(), kAllNames, toTranslate("or"))}));
      return;
    }
    row.rejectOtherCells(element);
  }

  /// False, with a diagnostic, where a cell with a text is under no name.
  bool hasOnlyNamedCells() {
    std::vector<bool> isNamed(m_fields.size());
    for (const auto& [name, position] : m_header) {
      if (position < isNamed.size()) isNamed[position] = true;
    }
    for (std::size_t i = 0; i < m_fields.size(); ++i) {
      if (isNamed[i] || m_fields[i].text.empty()) continue;
      m_diagnostics.add(Code::schema, translated("This cell is in a column without a name."), {},
                        m_fields[i].line, m_fields[i].column);
      return false;
    }
    if (m_records.count() <= m_fields.size()) return true;
    m_diagnostics.add(Code::schema, translated("This row has more cells than there are columns."), {},
                      m_fields.front().line, m_fields.front().column);
    return false;
  }

  bool readElement(std::string_view element, TableRowReader& row) {
    if (element == "document") {
      readDocument(row);
      return true;
    }
    bool isKnown = false;
    forEachField<Mechanism>([&](const auto& field) {
      isKnown = readInto(field.info().name, m_mechanism.*field.member, element, row) || isKnown;
    });
    return isKnown;
  }

  /// Adds the row to this member of the document; false if it is no list of such elements.
  template <class Value>
  bool readInto(std::string_view /*name*/, Value& /*no list*/, std::string_view /*element*/,
                TableRowReader& /*row*/) {
    return false;
  }
  template <class List>
  requires DescribedList<List>
  bool readInto(std::string_view name, List& list, std::string_view element, TableRowReader& row) {
    using Element = typename ElementOfList<List>::Type;
    if constexpr (std::is_same_v<Element, ShiftElement>) {
      ShiftElement coupling;
      const std::array kinds{ShiftElementKind::brake, ShiftElementKind::clutch, ShiftElementKind::freewheel};
      const auto kind = std::find_if(kinds.begin(), kinds.end(), [&](ShiftElementKind each) {
        return couplingKindName(each) == element;
      });
      if (kind == kinds.end()) return false;
      coupling.kind = *kind;
      coupling.links.resize(coupling.kind == ShiftElementKind::brake ? 1 : 2);
      add(name, list, row, std::move(coupling));
    } else {
      if (element != Description<Element>::name) return false;
      add(name, list, row, Element());
    }
    return true;
  }
  template <class Element>
  bool readInto(std::string_view name, std::optional<std::vector<Element>>& list, std::string_view element,
                TableRowReader& row) {
    if (element != Description<Element>::name) return false;
    if (!list) list.emplace();
    if (row.hasCells()) add(name, *list, row, Element());  // else there are none, as the document says
    return true;
  }

  void readDocument(TableRowReader& row) {
    if (m_documentPlace) return row.wrongRow(translated("There is one row \"document\" at most."));
    m_documentPlace = m_records.place();
    elementColumns(row, m_mechanism);
  }

  template <class Element>
  void add(std::string_view list, std::vector<Element>& elements, TableRowReader& row, Element element) {
    if (elements.size() == kMaxListLength) {
      m_isBeyondLimits = true;
      return row.wrongRow(translated("A document has at most 100,000 %1.", {list}));
    }
    if constexpr (requires { ElementId(element.id); }) row.template blameId<decltype(element.id)>();
    elementColumns(row, element);
    elements.push_back(std::move(element));
    m_places[list].push_back(m_records.place());
  }

  void addSemanticDiagnostics() {
    for (const Diagnostic& found : wellFormedDiagnostics(m_mechanism)) {
      const auto [line, column] = placeOf(found.pointer);
      m_diagnostics.add(found.code, found.message, found.elements, line, column);
    }
  }

  /// Line and column of a member, by its JSON pointer. The row is read once more, for the places of its
  /// cells.
  std::pair<int, int> placeOf(std::string_view pointer) {
    const std::vector<std::string_view> steps = stepsOf(pointer);
    if (steps.empty()) return {1, 1};
    std::optional<CsvRecords::Place> place = m_documentPlace;
    std::string_view member = steps.front();
    std::size_t next = 1;  // the step behind `member`
    if (const auto list = m_places.find(steps.front()); list != m_places.end() && steps.size() > 1) {
      const std::size_t position = positionOf(steps[1]);
      if (position < list->second.size()) place = list->second[position];
      member = steps.size() > 2 ? steps[2] : "id";
      next = 3;
    } else if (steps.front() == "gearDefaults" && steps.size() > 1) {
      member = steps[1];
      next = 2;
    }
    if (!place) return {1, 1};
    const std::string_view column = columnOf(member, steps.size() > next ? positionOf(steps[next]) : 0);
    m_records.moveTo(*place);
    if (!m_records.next(m_fields)) return {place->line, 1};
    const auto at = m_header.find(column);
    if (at == m_header.end() || at->second >= m_fields.size()) return {place->line, 1};
    return {m_fields[at->second].line, m_fields[at->second].column};
  }

  char m_separator;
  CsvRecords m_records;
  std::vector<CsvField> m_fields;
  TableHeader m_header;
  TableDiagnostics m_diagnostics;
  Mechanism m_mechanism;
  std::optional<CsvRecords::Place> m_documentPlace;
  std::unordered_map<std::string_view, std::vector<CsvRecords::Place>> m_places;  ///< rows by list
  bool m_isBeyondLimits = false;
};

}  // namespace

bool looksLikeTable(std::string_view bytes) {
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && bytes[first] != '{' && bytes[first] != '[';
}

Expected<Mechanism> readMechanismTable(std::string_view bytes) {
  if (bytes.size() > kLargestFile) {
    return Diagnostic{
        Code::schema,
        translated("The file has %1 bytes; at most 64 MiB are read.", {std::to_string(bytes.size())}),
        {},
        {},
        0,
        0};
  }
  return TableReader(bytes).run();
}

Expected<Mechanism> readMechanismOrTable(std::string_view bytes) {
  return looksLikeTable(bytes) ? readMechanismTable(bytes) : readMechanism(bytes);
}

}  // namespace geargraph
