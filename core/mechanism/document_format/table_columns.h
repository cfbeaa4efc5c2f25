#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/foundations/base/translation.h"
#include "core/mechanism/model/fields.h"

namespace geargraph {

/// The columns that tables of version 1 began with, in the order in which they are written. Those of members
/// that came later follow. Most are named like the member of the document; points are x y z; directions,
/// forces and gravity dx dy dz.
// clang-format off
constexpr auto kFirstColumns = std::to_array<std::string_view>({
    "element", "id", "name", "tail", "head", "axis", "link", "joint", "tailTeeth", "headTeeth", "kind", "x",
    "y", "z", "dx", "dy", "dz", "offset", "lowLimit", "highLimit", "faceWidth", "tailWheel", "headWheel",
    "efficiency", "friction", "speed", "torque", "profileShift", "bore", "backlash", "pressureAngle",
    "mass", "ixx", "iyy", "izz", "ixy", "ixz", "iyz", "sharing", "driveTorque", "density", "engaged", "drive", "driven", "pinned",
    "unit", "notes"});
// clang-format on

constexpr std::array<std::string_view, 3> kPlaceColumns = {"x", "y", "z"};
constexpr std::array<std::string_view, 3> kDirectionColumns = {"dx", "dy", "dz"};
constexpr std::array<std::string_view, 6> kInertiaColumns = {"ixx", "iyy", "izz", "ixy", "ixz", "iyz"};
constexpr std::string_view kLowLimit = "lowLimit";
constexpr std::string_view kHighLimit = "highLimit";

/// The three columns of a point or a direction.
constexpr const std::array<std::string_view, 3>& tripleColumns(const MemberInfo& info) {
  return info.measure == Measure::coordinate ? kPlaceColumns : kDirectionColumns;
}

/// Has the member one column of its own name?
constexpr bool hasOwnColumn(MemberValue value) {
  switch (value) {
    case MemberValue::text:
    case MemberValue::shortText:
    case MemberValue::id:
    case MemberValue::reference:
    case MemberValue::references:
    case MemberValue::flag:
    case MemberValue::teeth:
    case MemberValue::meshKind:
    case MemberValue::hand:
    case MemberValue::jointKind:
    case MemberValue::sharing:
    case MemberValue::number:
      return true;
    default:
      return false;
  }
}

/// Calls visit(name) for each column of its own that a member of the class has.
template <class Element, class Visit>
constexpr void forEachOwnColumn(const Visit& visit) {
  forEachField<Element>([&]<class Member>(const Member& field) {
    if (Member::kCount == 1 && hasOwnColumn(field.info().value)) visit(field.info().name);
  });
}

template <class Visit>
constexpr void forEachOwnColumnOfAll(const Visit& visit) {
  forEachOwnColumn<Mechanism>(visit);
  forEachOwnColumn<GearDefaults>(visit);
  forEachField<Mechanism>([&]<class Member>(const Member& /*field*/) {
    using Value = typename Member::Value;
    if constexpr (DescribedList<Value>) forEachOwnColumn<typename ElementOfList<Value>::Type>(visit);
    if constexpr (requires { typename ElementOfList<typename Value::value_type>::Type; })
      forEachOwnColumn<typename ElementOfList<typename Value::value_type>::Type>(visit);
  });
}

/// Names of columns, each once.
struct ColumnNames {
  std::array<std::string_view, 200> names{};
  std::size_t count = 0;

  constexpr void add(std::string_view name) {
    auto* const end = names.begin() + count;
    if (std::find(names.begin(), end, name) == end) names.at(count++) = name;
  }
};

constexpr ColumnNames kAllColumns = [] {
  ColumnNames all;
  for (const std::string_view name : kFirstColumns) all.add(name);
  forEachOwnColumnOfAll([&](std::string_view name) { all.add(name); });
  return all;
}();

/// Every column of a table of a mechanism, in the order in which they are written.
constexpr auto kTableColumns = [] {
  std::array<std::string_view, kAllColumns.count> all{};
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = kAllColumns.names[i];
  return all;
}();

// The cells of each element: one description for both the writer and the reader, so that they cannot
// diverge. A row type has `kReads` and, for each kind of value, a function that writes or reads one cell
// (TableRowWriter, TableRowReader).

/// The cells of a mass; an inertia or a centre is valid only together with a mass.
struct MassCells {
  std::optional<Number> mass;
  std::optional<NumberTriple> center;
  std::optional<InertiaNumbers> inertia;
};

template <class Row, class Mass>
void massColumns(Row& row, const std::array<MemberInfo, 3>& infos, Mass& mass) {
  MassCells cells;
  if (mass) cells = {mass->mass, mass->center, mass->inertia};
  row.number(infos[kMass].name, cells.mass);
  row.numbers(tripleColumns(infos[kCenterOfMass]), cells.center);
  row.numbers(kInertiaColumns, cells.inertia);
  if constexpr (Row::kReads) {
    if (cells.mass) {
      mass = LinkMass{*cells.mass, cells.center, cells.inertia};
    } else if (cells.center || cells.inertia) {
      row.wrong(cells.center ? kPlaceColumns.front() : kInertiaColumns.front(),
                translated("A centre of mass and an inertia need a \"mass\" beside them."));
    }
  }
}

/// The cell "element" distinguishes brake and clutch. @pre a brake has one link, a clutch two
template <class Row, class Links>
void couplingLinks(Row& row, const std::array<MemberInfo, 3>& infos, Links& links) {
  if (links.size() == 1) {
    row.id(infos[kBrakeLink].name, links.at(0));
  } else {
    row.id("tail", links.at(0));
    row.id("head", links.at(1));
  }
}

/// The cells of a load or a balance.
struct ActionCells {
  std::optional<JointId> joint;
  std::optional<LinkId> link;
  std::optional<AxisId> axis;
  std::optional<Number> torque;
  std::optional<NumberTriple> force;
  std::optional<NumberTriple> point;
};

template <class Row, std::size_t count>
void actionColumns(Row& row, const std::array<MemberInfo, count>& infos, ActionCells& cells) {
  row.id(infos[kActionJoint].name, cells.joint);
  row.id(infos[kActionLink].name, cells.link);
  row.id(infos[kActionAxis].name, cells.axis);
  if constexpr (count > kActionTorque) {
    row.number(infos[kActionTorque].name, cells.torque);
    row.numbers(tripleColumns(infos[kActionForce]), cells.force);
    row.numbers(tripleColumns(infos[kActionPoint]), cells.point);
  }
}

template <class Row, class Object>
void elementColumns(Row& row, Object& object);

/// The cells of one field. What tables do not have (lists, views) has none.
template <class Row, class Member, class Object>
void fieldColumns(Row& row, const Member& field, Object& object) {
  using Value = typename Member::Value;
  const MemberInfo& info = field.info();
  auto& value = object.*field.member;
  if constexpr (std::is_same_v<Value, std::string>) {
    row.text(info.name, value);
  } else if constexpr (std::is_same_v<Value, LoadId>) {
    std::optional<LoadId> id;
    if (!value.empty()) id = value;
    row.id(info.name, id);
    if constexpr (Row::kReads) value = id.value_or(LoadId());
  } else if constexpr (kIsId<Value> || std::is_same_v<Value, std::optional<LinkId>> ||
                       std::is_same_v<Value, std::optional<WheelId>>) {
    row.id(info.name, value);
  } else if constexpr (std::is_same_v<Value, std::vector<ShiftElementId>>) {
    row.ids(info.name, value);
  } else if constexpr (std::is_same_v<Value, bool>) {
    row.flag(info.name, value);
  } else if constexpr (std::is_same_v<Value, int>) {
    row.teeth(info.name, value);
  } else if constexpr (std::is_same_v<Value, Number>) {
    if (info.isNeeded) {
      row.requiredNumber(info.name, value);
    } else {
      row.numberOrZero(info.name, value);
    }
  } else if constexpr (std::is_same_v<Value, std::optional<Number>>) {
    row.number(info.name, value);
  } else if constexpr (std::is_same_v<Value, std::optional<NumberTriple>>) {
    row.numbers(tripleColumns(info), value);
  } else if constexpr (std::is_same_v<Value, JointLimits>) {
    row.number(kLowLimit, value.low);
    row.number(kHighLimit, value.high);
  } else if constexpr (std::is_same_v<Value, std::optional<MeshKind>>) {
    row.meshKind(info.name, value);
  } else if constexpr (std::is_same_v<Value, std::optional<Hand>>) {
    row.hand(info.name, value);
  } else if constexpr (std::is_same_v<Value, JointKind>) {
    row.jointKind(info.name, value);
  } else if constexpr (std::is_same_v<Value, std::optional<LoadSharing>>) {
    row.sharing(info.name, value);
  } else if constexpr (std::is_same_v<Value, SharedOptional<LinkMass>>) {
    massColumns(row, field.infos, value);
  } else if constexpr (std::is_same_v<Value, std::vector<LinkId>>) {
    couplingLinks(row, field.infos, value);
  } else if constexpr (std::is_same_v<Value, std::optional<GearDefaults>>) {
    GearDefaults defaults = value.value_or(GearDefaults());
    elementColumns(row, defaults);
    if constexpr (Row::kReads) {
      if (defaults != GearDefaults()) value = std::move(defaults);
    }
  } else if constexpr (std::is_same_v<Value, decltype(Load::action)> ||
                       std::is_same_v<Value, decltype(HoldingTorque::at)>) {
    row.action(field.infos, value);
  }
}

/// The cells of an element, or of the row "document", in the order of tables.
template <class Row, class Object>
void elementColumns(Row& row, Object& object) {
  using Element = std::remove_const_t<Object>;
  constexpr auto kOrder = listedOrder<Element>();
  [&]<std::size_t... at>(std::index_sequence<at...>) {
    (fieldColumns(row, std::get<kOrder[at]>(Description<Element>::fields), object), ...);
  }
  (std::make_index_sequence<kOrder.size()>());
}

}  // namespace geargraph
