// Reads a table of a mechanism: the header, a row at a time, then what the rows mean together.

#include <algorithm>
#include <charconv>
#include <unordered_map>

#include "core/foundations/base/wording.h"
#include "core/foundations/base/words.h"
#include "core/foundations/files/csv_records.h"
#include "core/mechanism/document_format/mechanism_file.h"
#include "core/mechanism/document_format/mechanism_table.h"
#include "core/mechanism/document_format/table_columns.h"
#include "core/mechanism/document_format/table_row_reader.h"
#include "core/mechanism/model/limits.h"
#include "core/mechanism/model/validate.h"

namespace geargraph::inline document_format {
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
  if (member == "point" || member == "pitchPoint" || member == "centerOfMass") return at(kPlaceColumns);
  if (member == "direction" || member == "gravity" || member == "force") return at(kDirectionColumns);
  if (member == "inertia") return at(kInertiaColumns);
  if (member == "limits") return "lowLimit";
  if (member == "links") return position == 0 ? "tail" : "head";  // of a clutch
  return member;
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
      row.wrong(
          "element",
          element.empty()
              ? translated("The column \"element\" is empty; it says what the row is about.")
              : translated("There is no element \"%1\": document, link, axis, turningJoint, gearMesh, wheel, "
                           "input, brake, clutch, state, load or balance.",
                           {element.substr(0, kMaxNameLength)}));
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
    } else if (element == "link") {
      add("links", m_mechanism.links, row, [](auto& r, Link& link) { linkColumns(r, link); });
    } else if (element == "axis") {
      add("axes", m_mechanism.axes, row, [](auto& r, Axis& axis) { axisColumns(r, axis); });
    } else if (element == "turningJoint") {
      add("turningJoints", m_mechanism.turningJoints, row,
          [](auto& r, TurningJoint& joint) { turningJointColumns(r, joint); });
    } else if (element == "gearMesh") {
      add("gearMeshes", m_mechanism.gearMeshes, row,
          [](auto& r, GearMesh& mesh) { gearMeshColumns(r, mesh); });
    } else if (element == "wheel") {
      add("wheels", m_mechanism.wheels, row, [](auto& r, Wheel& wheel) { wheelColumns(r, wheel); });
    } else if (element == "input") {
      if (!m_mechanism.inputs) m_mechanism.inputs.emplace();
      if (!row.hasCells()) return true;  // no inputs, as the document says
      add("inputs", *m_mechanism.inputs, row, [](auto& r, Input& input) { inputColumns(r, input); });
    } else if (element == "brake" || element == "clutch") {
      add("couplings", m_mechanism.couplings, row, [&](auto& r, Coupling& coupling) {
        coupling.kind = element == "brake" ? CouplingKind::brake : CouplingKind::clutch;
        coupling.links.resize(element == "brake" ? 1 : 2);
        couplingColumns(r, coupling);
      });
    } else if (element == "state") {
      add("states", m_mechanism.states, row, [](auto& r, ShiftState& state) { stateColumns(r, state); });
    } else if (element == "load") {
      add("loads", m_mechanism.loads, row, readLoad);
    } else if (element == "balance") {
      if (!m_mechanism.balances) m_mechanism.balances.emplace();
      if (!row.hasCells()) return true;
      add("balances", *m_mechanism.balances, row, readBalance);
    } else {
      return false;
    }
    return true;
  }

  void readDocument(TableRowReader& row) {
    if (m_documentPlace) return row.wrongRow(translated("There is one row \"document\" at most."));
    m_documentPlace = m_records.place();
    documentColumns(row, m_mechanism);
  }

  template <class Element, class Read>
  void add(const char* list, std::vector<Element>& elements, TableRowReader& row, const Read& read) {
    if (elements.size() == kMaxListLength) {
      m_isBeyondLimits = true;
      return row.wrongRow(translated("A document has at most 100,000 %1.", {list}));
    }
    Element element;
    if constexpr (requires { ElementId(element.id); }) row.template blameId<decltype(element.id)>();
    read(row, element);
    elements.push_back(std::move(element));
    m_places[list].push_back(m_records.place());
  }

  static bool readPlace(TableRowReader& row, const ActionCells& cells) {
    if (cells.joint.has_value() == cells.link.has_value()) {
      row.wrong(cells.joint ? "link" : "joint",
                translated("The row names a \"joint\" or a \"link\", one of them."));
      return false;
    }
    if (cells.joint && cells.axis)
      row.wrong("axis", translated("An \"axis\" is named beside a \"link\"; a joint has its own."));
    return true;
  }

  static void readLoad(TableRowReader& row, Load& load) {
    std::optional<LoadId> id;
    ActionCells cells;
    actionColumns(row, id, cells);
    if (id) load.id = *id;
    if (!readPlace(row, cells)) return;
    if (cells.torque.has_value() == (cells.force || cells.point))
      return row.wrong("torque",
                       translated("A load has a \"torque\", or a force (dx, dy, dz) at a point (x, y, z)."));
    if (cells.torque) {
      load.action = cells.joint ? decltype(load.action)(JointTorque{*cells.joint, *cells.torque})
                                : LinkTorque{*cells.link, cells.axis, *cells.torque};
      return;
    }
    if (!cells.link || cells.axis || !cells.force || !cells.point) {
      return row.wrong(
          "dx",
          translated("A force acts on a \"link\": it has dx, dy, dz and a point x, y, z, and no axis."));
    }
    load.action = LinkForce{*cells.link, *cells.force, *cells.point};
  }

  static void readBalance(TableRowReader& row, Balance& balance) {
    ActionCells cells;
    placeColumns(row, cells);
    if (!readPlace(row, cells)) return;
    if (cells.joint) {
      balance.at = *cells.joint;
    } else {
      balance.at = Balance::OnLink{*cells.link, cells.axis};
    }
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

}  // namespace geargraph::inline document_format
