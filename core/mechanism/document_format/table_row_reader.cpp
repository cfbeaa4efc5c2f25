#include "core/mechanism/document_format/table_row_reader.h"

#include <algorithm>
#include <charconv>

#include "core/foundations/base/text_lists.h"
#include "core/foundations/base/translation.h"
#include "core/foundations/files/utf8.h"
#include "core/mechanism/document_format/table_columns.h"
#include "core/mechanism/document_format/table_text.h"
#include "core/mechanism/model/limits.h"

namespace geargraph {
namespace {

/// A cell in a message, cut where it is long.
std::string quoted(const std::string& cell) {
  constexpr std::size_t kMaxShown = 60;
  if (cell.size() <= kMaxShown) return '"' + cell + '"';
  std::size_t end = 0;
  while (end < kMaxShown) end += std::max<std::size_t>(utf8Length(cell, end), 1);
  return '"' + cell.substr(0, end) + "...\"";
}

}  // namespace

void TableDiagnostics::add(Code code, std::string message, std::vector<ElementId> elements, int line,
                           int column) {
  if (isFull()) {
    m_hasMore = true;
    return;
  }
  m_found.push_back({code, std::move(message), std::move(elements), {}, line, column});
}

Diagnostics TableDiagnostics::all() const {
  Diagnostics found = m_found;
  if (m_hasMore) {
    const int line = found.back().line;
    const int column = found.back().column;
    found.push_back({Code::schema,
                     translated("More problems follow; only the first 100 are listed."),
                     {},
                     {},
                     line,
                     column});
  }
  return found;
}

TableRowReader::TableRowReader(const TableHeader& header, const std::vector<CsvField>& fields,
                               bool hasDecimalComma, TableDiagnostics& diagnostics)
    : m_header(header),
      m_fields(fields),
      m_hasDecimalComma(hasDecimalComma),
      m_diagnostics(diagnostics),
      m_isRead(fields.size()) {}

const std::string& TableRowReader::cell(std::string_view column) {
  static const std::string kNone;
  const auto found = m_header.find(column);
  if (found == m_header.end() || found->second >= m_fields.size()) return kNone;
  m_isRead[found->second] = true;
  return m_fields[found->second].text;
}

void TableRowReader::wrong(std::string_view column, std::string message) {
  const auto found = m_header.find(column);
  const bool hasCell = found != m_header.end() && found->second < m_fields.size();
  const CsvField& at = hasCell ? m_fields[found->second] : m_fields.front();
  m_diagnostics.add(Code::schema, std::move(message), m_blamed, at.line, at.column);
}

void TableRowReader::wrongRow(std::string message) {
  wrong("element", std::move(message));
  m_isRead.assign(m_isRead.size(), true);
}

void TableRowReader::missing(std::string_view column, std::string_view expected) {
  wrong(column, translated("The column \"%1\" is empty; expected %2.", {column, translated(expected)}));
}

void TableRowReader::unexpected(std::string_view column, std::string_view expected) {
  wrong(column, translated("The column \"%1\" has %2; expected %3.",
                           {column, quoted(cell(column)), translated(expected)}));
}

void TableRowReader::rejectOtherCells(std::string_view element) {
  for (const auto& [name, position] : m_header) {
    if (position >= m_fields.size() || m_isRead[position] || m_fields[position].text.empty()) continue;
    if (name == "element") continue;
    wrong(name, translated("The column \"%1\" has no meaning for the element \"%2\".", {name, element}));
  }
}

bool TableRowReader::hasCells() const {
  const std::size_t element = m_header.at("element");
  for (std::size_t i = 0; i < m_fields.size(); ++i) {
    if (i != element && !m_fields[i].text.empty()) return true;
  }
  return false;
}

void TableRowReader::text(std::string_view column, std::string& text) {
  if (const std::string& given = cell(column); !given.empty()) text = unguardedText(given);
}

std::string TableRowReader::shortId() {
  const std::string& text = cell("id");
  return text.size() <= kMaxNameLength ? unguardedText(text) : std::string();
}

std::optional<InternedString> TableRowReader::atom(std::string_view column) {
  const std::string text = unguardedText(cell(column));
  if (text.empty()) return std::nullopt;
  if (text.size() > kMaxNameLength && utf8Count(text) > kMaxNameLength) {
    unexpected(column, toTranslate("an id of at most 1,000 characters"));
    return std::nullopt;
  }
  return InternedString(text);
}

template <class Tag>
void TableRowReader::ids(std::string_view column, std::vector<Id<Tag>>& ids) {
  for (const std::string& text : splitTexts(unguardedText(cell(column)))) {
    if (ids.size() == kMaxListLength || text.empty() ||
        (text.size() > kMaxNameLength && utf8Count(text) > kMaxNameLength))
      return unexpected(column,
                        toTranslate("at most 100,000 ids of 1 to 1,000 characters, with a bar (|) between"));
    ids.emplace_back(text);
  }
}
template void TableRowReader::ids(std::string_view column, std::vector<ShiftElementId>& ids);

void TableRowReader::number(std::string_view column, std::optional<Number>& number) {
  std::string text = cell(column);
  if (text.empty()) return;
  if (m_hasDecimalComma && std::count(text.begin(), text.end(), ',') == 1)
    std::replace(text.begin(), text.end(), ',', '.');
  number = Number::fromText(text);
  if (!number) unexpected(column, toTranslate("a number, such as 12, -1.5, 1e-3 or 22/7"));
}

void TableRowReader::numberOrZero(std::string_view column, Number& number) {
  std::optional<Number> given;
  this->number(column, given);
  if (given) number = *given;
}

void TableRowReader::requiredNumber(std::string_view column, Number& number) {
  if (cell(column).empty()) return missing(column, toTranslate("a number"));
  numberOrZero(column, number);
}

void TableRowReader::teeth(std::string_view column, int& teeth) {
  const std::string& text = cell(column);
  if (text.empty()) return missing(column, toTranslate("a number of teeth"));
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), teeth);
  const bool isWhole = error == std::errc() && end == text.data() + text.size();
  if (!isWhole || teeth < kMinTeeth || teeth > kMaxTeeth)
    unexpected(column, toTranslate("a whole number from 1 to 100,000"));
}

void TableRowReader::meshKind(std::string_view column, std::optional<MeshKind>& kind) {
  const std::string& text = cell(column);
  if (text.empty()) return;
  kind = meshKindFrom(text);
  if (kind) return;
  std::vector<std::string> names;
  for (const MeshKind each : meshKinds()) names.emplace_back(meshKindName(each));
  unexpected(column, listed(names, kAllNames, "or"));
}

void TableRowReader::hand(std::string_view column, std::optional<Hand>& hand) {
  const std::string& text = cell(column);
  if (text.empty()) return;
  hand = handFrom(text);
  if (!hand) unexpected(column, toTranslate("right, left or nothing"));
}

void TableRowReader::jointKind(std::string_view column, JointKind& kind) {
  const std::string& text = cell(column);
  if (text.empty()) return;
  const std::optional<JointKind> named = jointKindFrom(text);
  if (named) {
    kind = *named;
  } else {
    unexpected(column, toTranslate("turning, sliding or nothing"));
  }
}

void TableRowReader::sharing(std::string_view column, std::optional<LoadSharing>& sharing) {
  const std::string& text = cell(column);
  if (text.empty()) return;
  sharing = loadSharingFrom(text);
  if (!sharing) unexpected(column, toTranslate("none, stiffness or nothing"));
}

void TableRowReader::flag(std::string_view column, bool& flag) {
  const std::string& text = cell(column);
  if (text.empty()) return;
  flag = text == "yes";
  if (!flag && text != "no") unexpected(column, toTranslate("yes, no or nothing"));
}

bool TableRowReader::namesPlace(const ActionCells& cells) {
  if (cells.joint.has_value() == cells.link.has_value()) {
    wrong(cells.joint ? "link" : "joint",
          translated("The row names a \"joint\" or a \"link\", one of them."));
    return false;
  }
  if (cells.joint && cells.axis)
    wrong("axis", translated("An \"axis\" is named beside a \"link\"; a joint has its own."));
  return true;
}

void TableRowReader::action(const std::array<MemberInfo, 6>& infos, decltype(Load::action)& action) {
  ActionCells cells;
  actionColumns(*this, infos, cells);
  if (!namesPlace(cells)) return;
  if (cells.torque.has_value() == (cells.force || cells.point))
    return wrong("torque",
                 translated("A load has a \"torque\", or a force (dx, dy, dz) at a point (x, y, z)."));
  if (cells.torque) {
    if (cells.joint) {
      action = JointTorque{*cells.joint, *cells.torque};
    } else {
      action = LinkTorque{*cells.link, cells.axis, *cells.torque};
    }
    return;
  }
  if (!cells.link || cells.axis || !cells.force || !cells.point) {
    return wrong(
        "dx", translated("A force acts on a \"link\": it has dx, dy, dz and a point x, y, z, and no axis."));
  }
  action = LinkForce{*cells.link, *cells.force, *cells.point};
}

void TableRowReader::action(const std::array<MemberInfo, 3>& infos, decltype(HoldingTorque::at)& at) {
  ActionCells cells;
  actionColumns(*this, infos, cells);
  if (!namesPlace(cells)) return;
  if (cells.joint) {
    at = *cells.joint;
  } else {
    at = HoldingTorque::OnLink{*cells.link, cells.axis};
  }
}

}  // namespace geargraph
