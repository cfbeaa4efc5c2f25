#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <utility>

#include "core/foundations/base/words.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph::inline document_format {

/// Every column of a table of a mechanism, in the order in which they are written. Most are named like the
/// member of the document; points are x y z; directions, forces and gravity dx dy dz.
// clang-format off
constexpr auto kTableColumns = std::to_array<std::string_view>({
    "element", "id", "name", "tail", "head", "axis", "link", "joint", "tailTeeth", "headTeeth", "kind", "x",
    "y", "z", "dx", "dy", "dz", "offset", "lowLimit", "highLimit", "faceWidth", "tailWheel", "headWheel",
    "efficiency", "friction", "speed", "torque", "profileShift", "bore", "backlash", "pressureAngle",
    "mass", "ixx", "iyy", "izz", "ixy", "ixz", "iyz", "sharing", "driveTorque", "density", "engaged", "drive", "driven", "pinned",
    "unit", "notes"});
// clang-format on

constexpr std::array<std::string_view, 3> kPlaceColumns = {"x", "y", "z"};
constexpr std::array<std::string_view, 3> kDirectionColumns = {"dx", "dy", "dz"};
constexpr std::array<std::string_view, 6> kInertiaColumns = {"ixx", "iyy", "izz", "ixy", "ixz", "iyz"};

// The columns of each element: one description for both the writer and the reader, so that they cannot
// diverge. A row type has `kReads` and, for each kind of value, a function that writes or reads one cell
// (TableRowWriter, TableRowReader).

template <class Row, class OneDocument>
void documentColumns(Row& row, OneDocument& document) {
  row.text("name", document.name);
  row.ids("engaged", document.engaged);
  GearDefaults defaults = document.gearDefaults.value_or(GearDefaults());
  row.number("pressureAngle", defaults.pressureAngle);
  row.number("backlash", defaults.backlash);
  row.number("faceWidth", defaults.faceWidth);
  row.number("efficiency", defaults.efficiency);
  row.number("friction", defaults.friction);
  if constexpr (Row::kReads) {
    if (defaults != GearDefaults()) document.gearDefaults = std::move(defaults);
  }
  row.sharing("sharing", document.sharing);
  row.number("driveTorque", document.driveTorque);
  row.number("density", document.density);
  row.numbers(kDirectionColumns, document.gravity);
  row.text("unit", document.unit);
  row.text("notes", document.notes);
}

/// The cells of a mass; an inertia or a centre is valid only together with a mass.
struct MassCells {
  std::optional<Number> mass;
  std::optional<NumberTriple> center;
  std::optional<InertiaNumbers> inertia;
};

template <class Row, class OneLink>
void linkColumns(Row& row, OneLink& link) {
  row.id("id", link.id);
  row.text("name", link.name);
  MassCells cells;
  if (link.mass) cells = {link.mass->mass, link.mass->center, link.mass->inertia};
  row.number("mass", cells.mass);
  row.numbers(kPlaceColumns, cells.center);
  row.numbers(kInertiaColumns, cells.inertia);
  if constexpr (Row::kReads) {
    if (cells.mass) {
      link.mass = LinkMass{*cells.mass, cells.center, cells.inertia};
    } else if (cells.center || cells.inertia) {
      row.wrong(cells.center ? "x" : "ixx",
                translated("A centre of mass and an inertia need a \"mass\" beside them."));
    }
  }
  row.flag("pinned", link.pinned);
}

template <class Row, class OneAxis>
void axisColumns(Row& row, OneAxis& axis) {
  row.id("id", axis.id);
  row.numbers(kPlaceColumns, axis.point);
  row.numbers(kDirectionColumns, axis.direction);
  row.flag("pinned", axis.pinned);
}

template <class Row, class OneJoint>
void turningJointColumns(Row& row, OneJoint& joint) {
  row.id("id", joint.id);
  row.id("tail", joint.tail);
  row.id("head", joint.head);
  row.id("axis", joint.axis);
  row.numberOrZero("offset", joint.offset);
  row.number("lowLimit", joint.limits.low);
  row.number("highLimit", joint.limits.high);
}

template <class Row, class OneMesh>
void gearMeshColumns(Row& row, OneMesh& mesh) {
  row.id("id", mesh.id);
  row.id("tail", mesh.tail);
  row.id("head", mesh.head);
  row.teeth("tailTeeth", mesh.tailTeeth);
  row.teeth("headTeeth", mesh.headTeeth);
  row.meshKind("kind", mesh.kind);
  row.numbers(kPlaceColumns, mesh.pitchPoint);
  row.number("faceWidth", mesh.faceWidth);
  row.id("tailWheel", mesh.tailWheel);
  row.id("headWheel", mesh.headWheel);
  row.number("efficiency", mesh.efficiency);
  row.number("friction", mesh.friction);
  row.flag("pinned", mesh.pinned);
}

template <class Row, class OneWheel>
void wheelColumns(Row& row, OneWheel& wheel) {
  row.id("id", wheel.id);
  row.id("link", wheel.link);
  row.number("profileShift", wheel.profileShift);
  row.number("bore", wheel.bore);
  row.number("backlash", wheel.backlash);
}

template <class Row, class OneInput>
void inputColumns(Row& row, OneInput& input) {
  row.id("joint", input.joint);
  row.requiredNumber("speed", input.speed);
}

/// The cell "element" distinguishes brake and clutch. @pre a brake has one link, a clutch two
template <class Row, class OneCoupling>
void couplingColumns(Row& row, OneCoupling& coupling) {
  row.id("id", coupling.id);
  if (coupling.kind == CouplingKind::brake) {
    row.id("link", coupling.links.at(0));
  } else {
    row.id("tail", coupling.links.at(0));
    row.id("head", coupling.links.at(1));
  }
}

template <class Row, class OneState>
void stateColumns(Row& row, OneState& state) {
  row.text("name", state.name);
  row.ids("engaged", state.engaged);
  row.id("drive", state.drive);
  row.id("driven", state.driven);
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

template <class Row>
void placeColumns(Row& row, ActionCells& cells) {
  row.id("joint", cells.joint);
  row.id("link", cells.link);
  row.id("axis", cells.axis);
}

template <class Row>
void actionColumns(Row& row, std::optional<LoadId>& id, ActionCells& cells) {
  row.id("id", id);
  placeColumns(row, cells);
  row.number("torque", cells.torque);
  row.numbers(kDirectionColumns, cells.force);
  row.numbers(kPlaceColumns, cells.point);
}

}  // namespace geargraph::inline document_format
