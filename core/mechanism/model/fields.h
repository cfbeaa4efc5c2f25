#pragma once

#include <array>
#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>

#include "core/foundations/base/translation.h"
#include "core/mechanism/model/mechanism.h"
#include "core/mechanism/model/member_info.h"

namespace geargraph {

// Every member of a document is described here, once: reader and writer of documents, tables and graphs,
// limits, patches, differences, fragments, requests of `serve`, the Python classes, the JSON Schema and the
// page of the format follow. A member is added to its class (mechanism.h, load.h) and to the description of
// that class (docs/adding/field.md).
//
// The order is that of files. A header of its own, so that mechanism.h stays cheap to include.

/// A member of a class and the member of the document that states it; several where an object of the document
/// states one member of the class together. The type of the value decides how it is read and written.
template <class OwnerType, class ValueType, std::size_t count>
struct Field {
  using Owner = OwnerType;
  using Value = ValueType;
  static constexpr std::size_t kCount = count;

  Value Owner::*member = nullptr;
  std::array<MemberInfo, count> infos{};

  [[nodiscard]] constexpr const MemberInfo& info() const { return infos[0]; }
};

template <class Owner, class Value>
constexpr Field<Owner, Value, 1> field(Value Owner::*member, const MemberInfo& info) {
  return {member, {info}};
}
template <class Owner, class Value, std::size_t count>
constexpr Field<Owner, Value, count> field(Value Owner::*member, const MemberInfo (&infos)[count]) {
  Field<Owner, Value, count> made{member, {}};
  for (std::size_t i = 0; i < count; ++i) made.infos[i] = infos[i];
  return made;
}

/// The description of a class that an object of documents is read into: which `part` of a document it is, its
/// `name` in the schema and in the column "element" of tables, and its `fields`.
template <class Element>
struct Description;

// The members of composite values, by position in Field::infos.
enum CouplingMember : std::size_t { kCouplingKind, kBrakeLink, kClutchLinks };
enum MassMember : std::size_t { kMass, kCenterOfMass, kInertia };
enum ActionMember : std::size_t {
  kActionJoint,
  kActionLink,
  kActionAxis,
  kActionTorque,
  kActionForce,
  kActionPoint
};

template <>
struct Description<LinkShape> {
  static constexpr DocumentPart part = DocumentPart::shape;
  static constexpr std::string_view name = "shape";
  static constexpr auto fields = std::make_tuple(
      field(&LinkShape::file,
            {.name = "file",
             .value = MemberValue::shortText,
             .meaning = "a path from the folder of the document, with slashes, that does not lead out of it",
             .isNeeded = true,
             .expected = toTranslate("a path that stays in the folder of this document")}),
      field(&LinkShape::position,
            {.name = "position",
             .value = MemberValue::triple,
             .meaning = "where the file's origin is, base frame: a point p of the file lies at position + R "
                        "(scale p), in the reference pose",
             .fallback = "the origin",
             .measure = Measure::coordinate}),
      field(&LinkShape::orientation,
            {.name = "orientation",
             .value = MemberValue::triple,
             .meaning = "R turns by these angles about x, then y, then z of the base frame",
             .fallback = "not turned",
             .measure = Measure::angle}),
      field(&LinkShape::scale, {.name = "scale",
                                .value = MemberValue::number,
                                .meaning = "the size of the file's unit in the document's",
                                .fallback = "1",
                                .measure = Measure::number,
                                .range = NumberRange::positive}));
};

template <>
struct Description<Link> {
  static constexpr DocumentPart part = DocumentPart::link;
  static constexpr std::string_view name = "link";
  static constexpr auto fields = std::make_tuple(
      field(&Link::id, {.name = "id",
                        .value = MemberValue::id,
                        .meaning = "unique among the links",
                        .isNeeded = true,
                        .attribute = "linkId"}),
      field(&Link::name,
            {.name = "name", .value = MemberValue::shortText, .meaning = "what the link is called"}),
      field(&Link::pinned, {.name = "pinned",
                            .value = MemberValue::flag,
                            .meaning = "its gears keep their teeth while other things are fitted",
                            .fallback = "false"}),
      field(&Link::mass,
            {{.name = "mass",
              .value = MemberValue::number,
              .meaning = "for dynamics. Without it mass, centre and inertia follow from the link's solids; a "
                         "mass alone is spread as the solids are",
              .measure = Measure::mass,
              .range = NumberRange::notNegative,
              .expected = toTranslate("a \"mass\" beside it")},
             {.name = "centerOfMass",
              .value = MemberValue::triple,
              .meaning = "in the reference pose, base frame; only beside a `mass`",
              .fallback = "that of the solids",
              .measure = Measure::coordinate},
             {.name = "inertia",
              .value = MemberValue::inertia,
              .meaning = "about the centre of mass, along the axes of the base frame: xx, yy, zz, xy, xz, "
                         "yz. Products as in the matrix: xy is minus the sum of m x y. Only beside a `mass`",
              .fallback = "as the solids spread the mass",
              .measure = Measure::moment}}),
      field(&Link::shapes,
            {.name = "shapes",
             .value = MemberValue::objects,
             .meaning =
                 "3D files (STL, OBJ, PLY, GLB) that are shown with the link: `{\"file\": \"parts/arm.stl\", "
                 "\"position\": [0, 0, 12], \"orientation\": [90, 0, 0], \"scale\": 1}`",
             .part = DocumentPart::shape,
             .expected = toTranslate("a list of 3D files"),
             .isInGraphs = false}));
};

template <>
struct Description<Axis> {
  static constexpr DocumentPart part = DocumentPart::axis;
  static constexpr std::string_view name = "axis";
  static constexpr auto fields = std::make_tuple(
      field(&Axis::id,
            {.name = "id", .value = MemberValue::id, .meaning = "unique among the axes", .isNeeded = true}),
      field(&Axis::point, {.name = "point",
                           .value = MemberValue::triple,
                           .meaning = "a point of the line in the reference pose, base frame",
                           .fallback = "the axis is placed from the tooth counts",
                           .measure = Measure::coordinate}),
      field(&Axis::direction, {.name = "direction",
                               .value = MemberValue::triple,
                               .meaning = "the direction of the line, of any length above 0",
                               .fallback = "the axis is placed from the tooth counts",
                               .measure = Measure::component}),
      field(&Axis::pinned, {.name = "pinned",
                            .value = MemberValue::flag,
                            .meaning = "it keeps its place while other things are fitted",
                            .fallback = "false"}));
};

template <>
struct Description<TurningJoint> {
  static constexpr DocumentPart part = DocumentPart::turningJoint;
  static constexpr std::string_view name = "turningJoint";
  static constexpr auto fields = std::make_tuple(
      field(&TurningJoint::id, {.name = "id",
                                .value = MemberValue::id,
                                .meaning = "unique among the turning joints",
                                .isNeeded = true,
                                .attribute = "edgeId"}),
      field(&TurningJoint::tail,
            {.name = "tail",
             .value = MemberValue::reference,
             .meaning = "`tail` to `head` is the orientation of the digraph's edge; positive speed turns "
                        "`head` about `+direction` of the axis relative to `tail`",
             .isNeeded = true,
             .target = ElementKind::link,
             .isInGraphs = false}),
      field(&TurningJoint::head, {.name = "head",
                                  .value = MemberValue::reference,
                                  .meaning = "another link",
                                  .isNeeded = true,
                                  .target = ElementKind::link,
                                  .isInGraphs = false}),
      field(&TurningJoint::axis, {.name = "axis",
                                  .value = MemberValue::reference,
                                  .meaning = "the line that it turns about",
                                  .isNeeded = true,
                                  .target = ElementKind::axis}),
      field(&TurningJoint::offset,
            {.name = "offset",
             .value = MemberValue::number,
             .meaning = "where along the axis the bearing is drawn, from the axis's point",
             .fallback = "0",
             .measure = Measure::length}),
      field(&TurningJoint::limits,
            {.name = "limits",
             .value = MemberValue::ends,
             .meaning = "how far it may turn from the reference pose, `[-170, 170]`: the lower end first, at "
                        "most 0, the upper at least 0; null is no limit. Of a sliding joint: how far it may "
                        "slide, in the document's unit",
             .fallback = "none",
             .measure = Measure::turn}),
      field(
          &TurningJoint::kind,
          {.name = "kind",
           .value = MemberValue::jointKind,
           .meaning = "`sliding`: the head moves along `+direction` of the axis relative to the tail, and "
                      "its speeds are in the document's unit of length a second. Sliding joints that share a "
                      "link and are parallel are of one class, as turning joints on one line are",
           .fallback = "`turning`",
           .attribute = "jointKind",
           .since = 2}));
};

template <>
struct Description<GearMesh> {
  static constexpr DocumentPart part = DocumentPart::gearMesh;
  static constexpr std::string_view name = "gearMesh";
  static constexpr auto fields = std::make_tuple(
      field(&GearMesh::id, {.name = "id",
                            .value = MemberValue::id,
                            .meaning = "unique among the meshes",
                            .isNeeded = true,
                            .attribute = "edgeId"}),
      field(&GearMesh::tail, {.name = "tail",
                              .value = MemberValue::reference,
                              .meaning = "the link of the first gear",
                              .isNeeded = true,
                              .target = ElementKind::link,
                              .isInGraphs = false}),
      field(&GearMesh::head, {.name = "head",
                              .value = MemberValue::reference,
                              .meaning = "the link of the second gear, another one",
                              .isNeeded = true,
                              .target = ElementKind::link,
                              .isInGraphs = false}),
      field(&GearMesh::tailTeeth, {.name = "tailTeeth",
                                   .value = MemberValue::teeth,
                                   .meaning = "teeth of the first gear",
                                   .isNeeded = true}),
      field(&GearMesh::headTeeth,
            {.name = "headTeeth",
             .value = MemberValue::teeth,
             .meaning = "teeth of the second gear; the ring of an internal pair has the more teeth",
             .isNeeded = true}),
      field(&GearMesh::pitchPoint,
            {.name = "pitchPoint",
             .value = MemberValue::triple,
             .meaning = "where the pitch surfaces touch in the reference pose, base frame",
             .fallback = "follows from axes, teeth and `kind`",
             .measure = Measure::coordinate,
             .listedAfter = "kind"}),
      field(&GearMesh::kind, {.name = "kind",
                              .value = MemberValue::meshKind,
                              .meaning = "optional where the geometry determines it",
                              .attribute = "meshKind"}),
      field(&GearMesh::faceWidth, {.name = "faceWidth",
                                   .value = MemberValue::number,
                                   .meaning = "the width of the gears along the axis (bevel: the cone)",
                                   .fallback = "that of `gearDefaults`",
                                   .measure = Measure::length,
                                   .range = NumberRange::positive}),
      field(&GearMesh::tailWheel,
            {.name = "tailWheel",
             .value = MemberValue::reference,
             .meaning = "the shape of the first gear. Without names, meshes on the same link, axis, tooth "
                        "count and plane (bevel: same apex and side) share one wheel, and shifts follow from "
                        "the centre distances",
             .target = ElementKind::wheel}),
      field(&GearMesh::headWheel, {.name = "headWheel",
                                   .value = MemberValue::reference,
                                   .meaning = "the shape of the second gear",
                                   .target = ElementKind::wheel}),
      field(&GearMesh::pinned, {.name = "pinned",
                                .value = MemberValue::flag,
                                .meaning = "it keeps its module while other things are fitted",
                                .fallback = "false",
                                .listedAfter = "friction"}),
      field(&GearMesh::efficiency,
            {.name = "efficiency",
             .value = MemberValue::number,
             .meaning = "of the power that crosses the teeth, seen from the carrier of the mesh",
             .fallback = "that of `gearDefaults`",
             .range = NumberRange::efficiency}),
      field(&GearMesh::friction, {.name = "friction",
                                  .value = MemberValue::number,
                                  .meaning = "the coefficient of friction of the teeth, instead of an "
                                             "`efficiency`",
                                  .fallback = "that of `gearDefaults`",
                                  .range = NumberRange::fraction}),
      field(
          &GearMesh::helixAngle,
          {.name = "helixAngle",
           .value = MemberValue::number,
           .meaning =
               "of the teeth of the first gear at its reference cylinder; of a bevel pair the spiral angle. "
               "Not of a worm, a face gear or a hypoid pair. The ratio does not depend on it",
           .fallback = "straight teeth; of `crossedHelical` the same angle on both gears",
           .measure = Measure::angle,
           .range = NumberRange::acuteAngle,
           .since = 2}),
      field(&GearMesh::hand,
            {.name = "hand",
             .value = MemberValue::hand,
             .meaning = "of the helix of the first gear. That of the second follows: the opposite one of an "
                        "external or bevel pair, the same of an internal one and of a worm, and of "
                        "`crossedHelical` that which the crossing angle leaves. Right-hand bevel teeth turn "
                        "clockwise outwards, seen from the apex",
             .fallback = "`right`; of `crossedHelical` without helix angle that which fits",
             .since = 2}),
      field(&GearMesh::herringbone,
            {.name = "herringbone",
             .value = MemberValue::flag,
             .meaning = "the helix changes its hand at mid face, so that no axial force is left; `hand` is "
                        "that of the half on the side against the direction of the first gear's axis",
             .fallback = "false",
             .since = 2}),
      field(&GearMesh::module,
            {.name = "module",
             .value = MemberValue::number,
             .meaning = "the normal module; with the centre distance it fixes the sum of the profile shifts. "
                        "Of a bevel pair or face gear without `pitchPoint`: the transverse one at the large "
                        "end, or at the pitch point; of a worm: in its axial section; of a rack, which needs "
                        "it or a `pitch`: that of the rack along its motion; of a hypoid pair without "
                        "`pitchPoint`: that of the larger gear at its pitch point",
             .fallback = "follows from the centre distance",
             .measure = Measure::length,
             .range = NumberRange::positive,
             .since = 2}),
      field(&GearMesh::pressureAngle, {.name = "pressureAngle",
                                       .value = MemberValue::number,
                                       .meaning = "of the teeth, in the normal section",
                                       .fallback = "that of `gearDefaults`",
                                       .measure = Measure::angle,
                                       .range = NumberRange::positive,
                                       .since = 2}),
      field(&GearMesh::crossed, {.name = "crossed",
                                 .value = MemberValue::flag,
                                 .meaning = "of a belt: its strands cross between the pulleys",
                                 .fallback = "false",
                                 .since = 2}),
      field(&GearMesh::pitch, {.name = "pitch",
                               .value = MemberValue::number,
                               .meaning = "of a belt: the length of one of its teeth; of a rack the same, "
                                          "along its motion, instead of a `module`",
                               .fallback = "follows from the distance of the axes",
                               .measure = Measure::length,
                               .range = NumberRange::positive,
                               .since = 2}),
      field(&GearMesh::tailDiameter,
            {.name = "tailDiameter",
             .value = MemberValue::number,
             .meaning = "of a belt, instead of `tailTeeth`: the running diameter of the first pulley; then "
                        "also `headDiameter`",
             .measure = Measure::length,
             .range = NumberRange::positive,
             .since = 2}),
      field(&GearMesh::headDiameter, {.name = "headDiameter",
                                      .value = MemberValue::number,
                                      .meaning = "the same of the second pulley",
                                      .measure = Measure::length,
                                      .range = NumberRange::positive,
                                      .since = 2}),
      field(&GearMesh::lead, {.name = "lead",
                              .value = MemberValue::number,
                              .meaning = "of a screw, which needs it: its advance in one turn",
                              .measure = Measure::length,
                              .range = NumberRange::positive,
                              .since = 2}));
};

template <>
struct Description<Wheel> {
  static constexpr DocumentPart part = DocumentPart::wheel;
  static constexpr std::string_view name = "wheel";
  static constexpr auto fields = std::make_tuple(
      field(&Wheel::id,
            {.name = "id", .value = MemberValue::id, .meaning = "unique among the wheels", .isNeeded = true}),
      field(&Wheel::link, {.name = "link",
                           .value = MemberValue::reference,
                           .meaning = "the link that it is on",
                           .isNeeded = true,
                           .target = ElementKind::link}),
      field(&Wheel::profileShift, {.name = "profileShift",
                                   .value = MemberValue::number,
                                   .meaning = "of its teeth",
                                   .fallback = "follows from the centre distances",
                                   .measure = Measure::modules}),
      field(&Wheel::bore, {.name = "bore",
                           .value = MemberValue::number,
                           .meaning = "the diameter of its bore",
                           .fallback = "follows from its shaft",
                           .measure = Measure::length}),
      field(&Wheel::backlash, {.name = "backlash",
                               .value = MemberValue::number,
                               .meaning = "of a pair; its teeth are thinner by half of it",
                               .fallback = "that of `gearDefaults`",
                               .measure = Measure::modules}));
};

template <>
struct Description<GearDefaults> {
  static constexpr DocumentPart part = DocumentPart::gearDefaults;
  static constexpr std::string_view name = "gearDefaults";
  static constexpr auto fields = std::make_tuple(
      field(&GearDefaults::pressureAngle, {.name = "pressureAngle",
                                           .value = MemberValue::number,
                                           .meaning = "of all gears",
                                           .fallback = "20",
                                           .measure = Measure::angle}),
      field(&GearDefaults::backlash, {.name = "backlash",
                                      .value = MemberValue::number,
                                      .meaning = "of wheels that state none",
                                      .fallback = "0.04",
                                      .measure = Measure::modules}),
      field(&GearDefaults::faceWidth, {.name = "faceWidth",
                                       .value = MemberValue::number,
                                       .meaning = "of meshes that state none",
                                       .fallback = "8 modules, less for bevels",
                                       .measure = Measure::length}),
      field(&GearDefaults::efficiency, {.name = "efficiency",
                                        .value = MemberValue::number,
                                        .meaning = "of meshes that state neither efficiency nor friction",
                                        .range = NumberRange::efficiency}),
      field(&GearDefaults::friction, {.name = "friction",
                                      .value = MemberValue::number,
                                      .meaning = "the same, as a coefficient of friction; not both",
                                      .range = NumberRange::fraction}));
};

template <>
struct Description<Input> {
  static constexpr DocumentPart part = DocumentPart::input;
  static constexpr std::string_view name = "input";
  static constexpr auto fields =
      std::make_tuple(field(&Input::joint, {.name = "joint",
                                            .value = MemberValue::reference,
                                            .meaning = "the joint that is driven",
                                            .isNeeded = true,
                                            .target = ElementKind::turningJoint,
                                            .namesElement = true}),
                      field(&Input::speed, {.name = "speed",
                                            .value = MemberValue::number,
                                            .meaning = "of the head relative to the tail",
                                            .isNeeded = true,
                                            .measure = Measure::speed,
                                            .expected = toTranslate("a speed in rad/s")}));
};

template <>
struct Description<ShiftElement> {
  static constexpr DocumentPart part = DocumentPart::coupling;
  static constexpr std::string_view name = "coupling";
  static constexpr auto fields = std::make_tuple(
      field(&ShiftElement::id, {.name = "id",
                                .value = MemberValue::id,
                                .meaning = "unique among the couplings",
                                .isNeeded = true}),
      field(&ShiftElement::links,
            {{.name = "kind",
              .value = MemberValue::couplingKind,
              .meaning = "engaged, a brake holds a link against the ground, a clutch makes two links turn as "
                         "one; a freewheel (version 2) lets its first link turn slower than its second, in "
                         "`+direction` of the axis of the first link's own joint, and locks where it would "
                         "turn faster; one of the two may be the ground",
              .isNeeded = true,
              .expected = toTranslate("\"brake\", \"clutch\" or \"freewheel\"")},
             {.name = "link",
              .value = MemberValue::reference,
              .meaning = "the link that a brake holds",
              .target = ElementKind::link},
             {.name = "links",
              .value = MemberValue::references,
              .meaning = "the two links of a clutch or of a freewheel",
              .target = ElementKind::link,
              .expected = toTranslate("a list of two ids of links")}}));
};

template <>
struct Description<ShiftState> {
  static constexpr DocumentPart part = DocumentPart::state;
  static constexpr std::string_view name = "state";
  static constexpr auto fields = std::make_tuple(
      field(&ShiftState::name, {.name = "name",
                                .value = MemberValue::shortText,
                                .meaning = "unique among the states",
                                .isNeeded = true,
                                .expected = toTranslate("the name of the state")}),
      field(&ShiftState::engaged, {.name = "engaged",
                                   .value = MemberValue::references,
                                   .meaning = "the couplings that are engaged together",
                                   .isNeeded = true,
                                   .target = ElementKind::coupling,
                                   .expected = toTranslate("a list of ids of couplings")}),
      field(&ShiftState::drive,
            {.name = "drive",
             .value = MemberValue::reference,
             .meaning = "the ratio of a state is the absolute speed of `drive` over that of `driven`, about "
                        "their common direction",
             .target = ElementKind::link}),
      field(&ShiftState::driven, {.name = "driven",
                                  .value = MemberValue::reference,
                                  .meaning = "the link that is driven",
                                  .target = ElementKind::link}),
      field(&ShiftState::direction,
            {.name = "direction",
             .value = MemberValue::number,
             .meaning = "-1: `drive` turns against `+direction` of its axis, 1: along it. Decides only which "
                        "freewheels lock",
             .fallback = "1",
             .since = 2}));
};

template <>
struct Description<Load> {
  static constexpr DocumentPart part = DocumentPart::load;
  static constexpr std::string_view name = "load";
  static constexpr auto fields = std::make_tuple(
      field(&Load::id,
            {.name = "id", .value = MemberValue::id, .meaning = "unique among the loads that have one"}),
      field(&Load::action,
            {{.name = "joint",
              .value = MemberValue::reference,
              .meaning = "the turning joint that bears the load: a torque by its tail on its head",
              .target = ElementKind::turningJoint},
             {.name = "link",
              .value = MemberValue::reference,
              .meaning = "or the link on which a torque or a force acts from outside; not the ground",
              .target = ElementKind::link},
             {.name = "axis",
              .value = MemberValue::reference,
              .meaning = "the axis about whose direction a torque on a link acts",
              .fallback = "the link's first one on the way to the ground",
              .target = ElementKind::axis},
             {.name = "torque",
              .value = MemberValue::number,
              .meaning = "about `+direction` of the axis",
              .measure = Measure::torque,
              .expected = toTranslate("a torque in N m")},
             {.name = "force",
              .value = MemberValue::triple,
              .meaning = "on the `link`, base frame, instead of a torque",
              .measure = Measure::force},
             {.name = "point",
              .value = MemberValue::triple,
              .meaning = "where the force acts, base frame; beside a `force`",
              .measure = Measure::coordinate,
              .expected = toTranslate("the point of the link that the force acts at")}}));
};

template <>
struct Description<HoldingTorque> {
  static constexpr DocumentPart part = DocumentPart::balance;
  static constexpr std::string_view name = "balance";
  static constexpr auto fields = std::make_tuple(
      field(&HoldingTorque::at, {{.name = "joint",
                                  .value = MemberValue::reference,
                                  .meaning = "the turning joint in which the torque to be found acts",
                                  .target = ElementKind::turningJoint},
                                 {.name = "link",
                                  .value = MemberValue::reference,
                                  .meaning = "or the link on which it acts from outside; not the ground",
                                  .target = ElementKind::link},
                                 {.name = "axis",
                                  .value = MemberValue::reference,
                                  .meaning = "the axis about whose direction it acts on a link",
                                  .fallback = "the link's first one on the way to the ground",
                                  .target = ElementKind::axis}}));
};

template <>
struct Description<CanvasNote> {
  static constexpr DocumentPart part = DocumentPart::note;
  static constexpr std::string_view name = "note";
  static constexpr auto fields = std::make_tuple(
      field(&CanvasNote::id,
            {.name = "id", .value = MemberValue::id, .meaning = "unique among the notes", .isNeeded = true}),
      field(&CanvasNote::text,
            {.name = "text",
             .value = MemberValue::text,
             .meaning = "1 to 1,000 characters, not blank, no control characters but line ends",
             .isNeeded = true,
             .expected = toTranslate("the text of the note")}),
      field(&CanvasNote::at, {.name = "at",
                              .value = MemberValue::place,
                              .meaning = "its middle",
                              .isNeeded = true,
                              .measure = Measure::coordinate,
                              .expected = toTranslate("the middle of the note")}));
};

template <>
struct Description<ViewCamera> {
  static constexpr DocumentPart part = DocumentPart::camera;
  static constexpr std::string_view name = "camera";
  static constexpr auto fields = std::make_tuple(
      field(&ViewCamera::target, {.name = "target",
                                  .value = MemberValue::position,
                                  .meaning = "the point that it looks at",
                                  .isNeeded = true,
                                  .measure = Measure::coordinate,
                                  .expected = toTranslate("the point that the camera looks at")}),
      field(&ViewCamera::azimuth, {.name = "azimuth",
                                   .value = MemberValue::measure,
                                   .meaning = "about +z",
                                   .isNeeded = true,
                                   .measure = Measure::turn,
                                   .expected = toTranslate("an angle in degrees")}),
      field(&ViewCamera::elevation, {.name = "elevation",
                                     .value = MemberValue::measure,
                                     .meaning = "above the x-y plane",
                                     .isNeeded = true,
                                     .measure = Measure::turn,
                                     .expected = toTranslate("an angle in degrees")}),
      field(&ViewCamera::distance, {.name = "distance",
                                    .value = MemberValue::measure,
                                    .meaning = "from the target",
                                    .isNeeded = true,
                                    .measure = Measure::length,
                                    .range = NumberRange::positive,
                                    .expected = toTranslate("a number above 0")}));
};

template <>
struct Description<View> {
  static constexpr DocumentPart part = DocumentPart::view;
  static constexpr std::string_view name = "view";
  static constexpr auto fields = std::make_tuple(
      field(&View::nodes,
            {.name = "nodes",
             .value = MemberValue::places,
             .meaning = "centres of the digraph's nodes by the id of their link, x to the right "
                        "and y down",
             .measure = Measure::coordinate}),
      field(&View::ttNodes, {.name = "ttNodes",
                             .value = MemberValue::places,
                             .meaning = "the same for nodes of the T-T graph that were dragged",
                             .measure = Measure::coordinate}),
      field(&View::notes, {.name = "notes",
                           .value = MemberValue::objects,
                           .meaning = "texts on the digraph's sheet, at most 1,000: `{\"id\": \"N1\", "
                                      "\"text\": \"sun\", \"at\": [120, 40]}`",
                           .part = DocumentPart::note,
                           .expected = toTranslate("a list of notes")}),
      field(&View::camera, {.name = "camera",
                            .value = MemberValue::object,
                            .meaning = "of the 3D view: `{\"target\": [0, 0, 0], \"azimuth\": -26, "
                                       "\"elevation\": 20, \"distance\": 400}`",
                            .part = DocumentPart::camera}),
      field(&View::colors,
            {.name = "colors",
             .value = MemberValue::numbersOfLinks,
             .meaning = "numbers of the colours of links by the id of their link, `{\"3\": 4}`, where they "
                        "are not the labels: links keep their colours while labels move",
             .fallback = "the labels"}));
};

template <>
struct Description<Mechanism> {
  static constexpr DocumentPart part = DocumentPart::document;
  static constexpr std::string_view name = "document";
  /// What is the same in every document.
  static constexpr std::array head = {MemberInfo{.name = "format",
                                                 .value = MemberValue::constant,
                                                 .meaning = "`\"geargraph\"`",
                                                 .isNeeded = true,
                                                 .isInGraphs = false},
                                      MemberInfo{.name = "version",
                                                 .value = MemberValue::constant,
                                                 .meaning = "1, or 2 if a member or value since "
                                                            "version 2 occurs",
                                                 .isNeeded = true,
                                                 .isInGraphs = false}};
  static constexpr auto fields = std::make_tuple(
      field(&Mechanism::name,
            {.name = "name", .value = MemberValue::shortText, .meaning = "what the mechanism is called"}),
      field(&Mechanism::notes, {.name = "notes", .value = MemberValue::text, .meaning = "free text"}),
      field(&Mechanism::unit, {.name = "unit",
                               .value = MemberValue::shortText,
                               .meaning = "of all lengths",
                               .fallback = "`mm`",
                               .isAlwaysWritten = true}),
      field(&Mechanism::links,
            {.name = "links",
             .value = MemberValue::objects,
             .meaning = "the first is the ground (label 0), the rest are labelled 1..n in order",
             .isNeeded = true,
             .part = DocumentPart::link,
             .expected = toTranslate("a list of links, the ground first"),
             .isAlwaysWritten = true,
             .isInGraphs = false}),
      field(&Mechanism::axes,
            {.name = "axes",
             .value = MemberValue::objects,
             .meaning = "the lines that turning joints turn about, in the reference pose, in the base frame. "
                        "Joints that stay coaxial for every motion share one axis; axes that coincide in the "
                        "reference pose only are two. Needed where there are joints",
             .part = DocumentPart::axis,
             .expected = toTranslate("a list of the axes that the turning joints name"),
             .isAlwaysWritten = true}),
      field(&Mechanism::turningJoints,
            {.name = "turningJoints",
             .value = MemberValue::objects,
             .meaning = "labelled n+1..n+t in order. Needed where links move",
             .part = DocumentPart::turningJoint,
             .expected = toTranslate("a list of turning joints that tie the links"),
             .isAlwaysWritten = true,
             .isInGraphs = false}),
      field(&Mechanism::gearMeshes, {.name = "gearMeshes",
                                     .value = MemberValue::objects,
                                     .meaning = "labelled n+t+1..n+t+c in order",
                                     .part = DocumentPart::gearMesh,
                                     .isAlwaysWritten = true,
                                     .isInGraphs = false}),
      field(&Mechanism::wheels,
            {.name = "wheels",
             .value = MemberValue::objects,
             .meaning = "shapes of toothed wheels, which meshes name by their ids: `{\"id\": \"7'\", "
                        "\"link\": \"7\", \"profileShift\": 0, \"bore\": 8, \"backlash\": 0.04}`",
             .part = DocumentPart::wheel}),
      field(&Mechanism::gearDefaults, {.name = "gearDefaults",
                                       .value = MemberValue::object,
                                       .meaning = "for all gears",
                                       .part = DocumentPart::gearDefaults}),
      field(&Mechanism::inputs,
            {.name = "inputs",
             .value = MemberValue::objects,
             .meaning = "the driven joints with their speeds; their order is the order of the solution's "
                        "columns",
             .fallback = "a valid set is chosen",
             .part = DocumentPart::input}),
      field(&Mechanism::couplings,
            {.name = "couplings",
             .value = MemberValue::objects,
             .meaning = "brakes and clutches: `{\"id\": \"A\", \"kind\": \"brake\", \"link\": \"5\"}`, "
                        "`{\"id\": \"E\", \"kind\": \"clutch\", \"links\": [\"1\", \"4\"]}`; freewheels: "
                        "`{\"id\": \"F\", \"kind\": \"freewheel\", \"links\": [\"1\", \"4\"]}`. They have no "
                        "label and no row of a matrix",
             .part = DocumentPart::coupling}),
      field(&Mechanism::states,
            {.name = "states",
             .value = MemberValue::objects,
             .meaning = "what is engaged together: `{\"name\": \"1\", \"engaged\": [\"A\", \"E\"], "
                        "\"drive\": \"1\", \"driven\": \"7\"}`",
             .part = DocumentPart::state}),
      field(&Mechanism::engaged,
            {.name = "engaged",
             .value = MemberValue::references,
             .meaning = "the couplings that are engaged now. Rank, freedom, inputs, solutions, motion and "
                        "statics are those of the train as engaged: each coupling adds named rows below P. "
                        "The matrices stay those of the train. Of `inputs`, those that the couplings leave "
                        "free are driven, in their order; the others follow",
             .target = ElementKind::coupling}),
      field(&Mechanism::loads,
            {.name = "loads",
             .value = MemberValue::objects,
             .meaning = "what acts on the mechanism in the reference pose: `{\"joint\": \"14\", \"torque\": "
                        "10}`, `{\"link\": \"3\", \"axis\": \"e\", \"torque\": \"-5/2\"}`, `{\"link\": "
                        "\"3\", \"force\": [0, 0, -20], \"point\": [0, 40, 132]}`. Several loads on one "
                        "element add up; the ground has none",
             .part = DocumentPart::load}),
      field(&Mechanism::balances,
            {.name = "balances",
             .value = MemberValue::objects,
             .meaning = "the torques that have to hold the loads and are to be found: `[{\"joint\": \"8\"}, "
                        "{\"link\": \"7\", \"axis\": \"a\"}]`",
             .fallback = "the inputs that bear no load of their own",
             .part = DocumentPart::balance}),
      field(&Mechanism::sharing,
            {.name = "sharing",
             .value = MemberValue::sharing,
             .meaning = "how loads are shared that equilibrium alone does not share out: `\"stiffness\"` "
                        "(all teeth equally stiff, no clearance, rigid bodies) or `\"none\"` (left open). "
                        "Without it they are left open, but for losses, which depend on them: with losses "
                        "they are shared by stiffness, and that is reported"}),
      field(&Mechanism::driveTorque,
            {.name = "driveTorque",
             .value = MemberValue::number,
             .meaning = "at the drive of every state in the shift table",
             .fallback = "the torque of the loads on a link that drives states, else 1",
             .measure = Measure::torque}),
      field(&Mechanism::density, {.name = "density",
                                  .value = MemberValue::number,
                                  .meaning = "of all solids",
                                  .fallback = "7850",
                                  .measure = Measure::density,
                                  .range = NumberRange::positive}),
      field(&Mechanism::gravity,
            {.name = "gravity",
             .value = MemberValue::triple,
             .meaning = "the acceleration of free fall in the base frame, `[0, 0, -9.81]`",
             .fallback = "none",
             .measure = Measure::acceleration}),
      field(&Mechanism::view, {.name = "view",
                               .value = MemberValue::object,
                               .meaning = "the editor's own; no number of the analysis depends on it",
                               .part = DocumentPart::view,
                               .isInGraphs = false}));
};

template <class Element>
concept Described = requires {
  Description<Element>::fields;
};

/// Every described class, in the order of DocumentPart.
using DescribedClasses =
    std::tuple<Mechanism, Link, LinkShape, Axis, TurningJoint, GearMesh, Wheel, GearDefaults, Input,
               ShiftElement, ShiftState, Load, HoldingTorque, View, CanvasNote, ViewCamera>;

template <class Value>
struct ElementOfList;
template <class Element>
requires Described<Element>
struct ElementOfList<std::vector<Element>> {
  using Type = Element;
};
template <class Tag, class Element>
requires Described<Element>
struct ElementOfList<OrdinalVector<Tag, Element>> {
  using Type = Element;
};

/// A list of described elements.
template <class Value>
concept DescribedList = requires {
  typename ElementOfList<Value>::Type;
};

template <class Value>
constexpr bool kIsId = false;
template <class Tag>
constexpr bool kIsId<Id<Tag>> = true;

/// Has every element of the class an id?
template <class Element>
constexpr bool kNeedsId = std::apply(
    [](const auto&... fields) {
      return ((fields.info().value == MemberValue::id && fields.info().isNeeded) || ...);
    },
    Description<Element>::fields);

/// Calls visit(field) for every field of the class, in the order of files.
template <class Element, class Visit>
constexpr void forEachField(const Visit& visit) {
  std::apply([&](const auto&... fields) { (visit(fields), ...); }, Description<Element>::fields);
}

/// The positions of the fields of a class in the order of tables and edits (MemberInfo::listedAfter).
template <class Element>
constexpr auto listedOrder() {
  constexpr auto& fields = Description<Element>::fields;
  constexpr std::size_t count = std::tuple_size_v<std::remove_cvref_t<decltype(fields)>>;
  const auto infos = std::apply(
      [](const auto&... each) { return std::array<MemberInfo, sizeof...(each)>{each.info()...}; }, fields);
  std::array<std::size_t, count> order{};
  for (std::size_t i = 0; i < count; ++i) order[i] = i;
  for (std::size_t i = count; i-- > 0;) {  // from the last: those before it are still in place
    if (infos[i].listedAfter.empty()) continue;
    std::size_t at = 0;
    while (order[at] != i) ++at;
    for (; infos[order[at]].name != infos[i].listedAfter; ++at) order[at] = order[at + 1];
    order[at] = i;
  }
  return order;
}

}  // namespace geargraph
