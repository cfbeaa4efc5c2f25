#include <algorithm>

#include "core/foundations/base/translation.h"
#include "core/foundations/files/csv_records.h"
#include "core/mechanism/document_format/mechanism_table.h"
#include "core/mechanism/document_format/table_columns.h"
#include "core/mechanism/document_format/table_text.h"

namespace geargraph {
namespace {

constexpr std::size_t kColumns = kTableColumns.size();

std::size_t indexOf(std::string_view column) {
  const auto found = std::find(kTableColumns.begin(), kTableColumns.end(), column);
  return static_cast<std::size_t>(found - kTableColumns.begin());
}

ActionCells cellsOf(const decltype(Load::action)& action) {
  if (const auto* inJoint = std::get_if<JointTorque>(&action))
    return {inJoint->joint, {}, {}, inJoint->torque, {}, {}};
  if (const auto* torque = std::get_if<LinkTorque>(&action))
    return {{}, torque->link, torque->axis, torque->torque, {}, {}};
  const auto& force = std::get<LinkForce>(action);
  return {{}, force.link, {}, {}, force.force, force.point};
}

ActionCells cellsOf(const decltype(HoldingTorque::at)& at) {
  if (const auto* joint = std::get_if<JointId>(&at)) return {*joint, {}, {}, {}, {}, {}};
  const auto& onLink = std::get<HoldingTorque::OnLink>(at);
  return {{}, onLink.link, onLink.axis, {}, {}, {}};
}

/// The word of a row, in the column "element".
template <class Element>
std::string_view rowWord(const Element& /*element*/) {
  return Description<Element>::name;
}
std::string_view rowWord(const ShiftElement& coupling) {
  return couplingKindName(coupling.kind);
}

/// The cells of one element.
class TableRowWriter {
 public:
  static constexpr bool kReads = false;

  explicit TableRowWriter(std::string_view element) { cell("element", std::string(element)); }

  void text(std::string_view column, const std::string& text) { cell(column, guardedText(text)); }
  template <class Tag>
  void id(std::string_view column, const Id<Tag>& id) {
    text(column, id.text());
  }
  template <class Tag>
  void id(std::string_view column, const std::optional<Id<Tag>>& id) {
    if (id) text(column, id->text());
  }
  template <class Tag>
  void ids(std::string_view column, const std::vector<Id<Tag>>& ids) {
    std::vector<std::string> texts;
    for (const Id<Tag>& id : ids) texts.push_back(id.text());
    text(column, joinedTexts(texts));
  }
  void number(std::string_view column, const std::optional<Number>& number) {
    if (number) cell(column, number->text());
  }
  void numberOrZero(std::string_view column, const Number& number) {
    if (number != Number()) cell(column, number.text());
  }
  void requiredNumber(std::string_view column, const Number& number) { cell(column, number.text()); }
  template <std::size_t count>
  void numbers(const std::array<std::string_view, count>& columns,
               const std::optional<std::array<Number, count>>& numbers) {
    for (std::size_t i = 0; numbers && i < count; ++i) cell(columns.at(i), numbers->at(i).text());
  }
  void teeth(std::string_view column, int teeth) { cell(column, std::to_string(teeth)); }
  void meshKind(std::string_view column, const std::optional<MeshKind>& kind) {
    if (kind) cell(column, std::string(meshKindName(*kind)));
  }
  void hand(std::string_view column, const std::optional<Hand>& hand) {
    if (hand) cell(column, std::string(handName(*hand)));
  }
  void jointKind(std::string_view column, JointKind kind) {
    if (kind != JointKind::turning) cell(column, std::string(jointKindName(kind)));
  }
  void sharing(std::string_view column, const std::optional<LoadSharing>& sharing) {
    if (sharing) cell(column, std::string(loadSharingName(*sharing)));
  }
  void flag(std::string_view column, bool flag) {
    if (flag) cell(column, "yes");
  }
  template <std::size_t count, class Action>
  void action(const std::array<MemberInfo, count>& infos, const Action& action) {
    ActionCells given = cellsOf(action);
    actionColumns(*this, infos, given);
  }

  std::array<std::string, kColumns> cells;

 private:
  void cell(std::string_view column, std::string text) { cells.at(indexOf(column)) = std::move(text); }
};

/// Gives every row of the mechanism to `take`.
template <class Take>
void forEachRow(const Mechanism& mechanism, const Take& take) {
  const auto rows = [&](const auto& elements) {
    for (const auto& element : elements) {
      TableRowWriter row(rowWord(element));
      elementColumns(row, element);
      take(row);
    }
  };
  TableRowWriter document("document");
  elementColumns(document, mechanism);
  take(document);
  forEachField<Mechanism>([&]<class Member>(const Member& field) {
    const auto& value = mechanism.*field.member;
    if constexpr (DescribedList<typename Member::Value>) {
      rows(value);
    } else if constexpr (requires { typename ElementOfList<typename Member::Value::value_type>::Type; }) {
      if (!value) return;
      rows(*value);
      using Element = typename ElementOfList<typename Member::Value::value_type>::Type;
      if (value->empty()) take(TableRowWriter(Description<Element>::name));  // none, as the document says
    }
  });
}

/// Drops the members that this program does not know, of an object or of each of a list; true where there
/// were any.
template <class Value>
bool dropUnknown(Value& value) {
  bool had = false;
  if constexpr (requires { value.unknown; }) {
    had = !value.unknown.empty();
    value.unknown.clear();
  } else if constexpr (DescribedList<Value>) {
    for (auto& element : value) had = dropUnknown(element) || had;
  } else if constexpr (
      requires { value->size(); } || requires { value->unknown; }) {
    if (value) had = dropUnknown(*value);
  }
  return had;
}

bool dropUnknownOfAll(Mechanism& mechanism) {
  bool had = dropUnknown(mechanism);
  forEachField<Mechanism>([&](const auto& field) { had = dropUnknown(mechanism.*field.member) || had; });
  return had;
}

}  // namespace

std::string writeMechanismTable(const Mechanism& mechanism, const TableOptions& options) {
  std::array<bool, kColumns> isUsed{};
  forEachRow(mechanism, [&](const TableRowWriter& row) {
    for (std::size_t i = 0; i < kColumns; ++i) isUsed.at(i) = isUsed.at(i) || !row.cells.at(i).empty();
  });
  std::string table = options.byteOrderMark ? "\xEF\xBB\xBF" : "";
  const auto line = [&](const auto& cells) {
    for (std::size_t i = 0; i < kColumns; ++i) {
      if (!isUsed.at(i)) continue;
      if (i > 0) table += options.separator;
      table += csvField(cells.at(i), options.separator);
    }
    table += '\n';
  };
  line(kTableColumns);
  forEachRow(mechanism, [&](const TableRowWriter& row) { line(row.cells); });
  return table;
}

TablePart tablePart(Mechanism mechanism) {
  TablePart part;
  std::size_t shapes = 0;
  for (Link& link : mechanism.links) {
    shapes += link.shapes.size();
    link.shapes.clear();
  }
  if (shapes > 0)
    part.lost.push_back(shapes == 1 ? translated("an attached 3D file")
                                    : translated("%1 attached 3D files", {std::to_string(shapes)}));
  if (mechanism.view != View())
    part.lost.push_back(translated("the view (places in the drawings, camera of the 3D view)"));
  mechanism.view = {};
  if (dropUnknownOfAll(mechanism)) part.lost.push_back(translated("members that this program does not know"));
  if (mechanism.unit.empty()) {
    part.lost.push_back(translated("the empty name of the unit, which becomes \"mm\""));
    mechanism.unit = Mechanism().unit;
  }
  if (mechanism.gearDefaults == GearDefaults()) mechanism.gearDefaults.reset();  // without a meaning
  part.mechanism = std::move(mechanism);
  return part;
}

}  // namespace geargraph
