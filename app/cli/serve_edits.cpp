#include "app/cli/serve_edits.h"

#include <algorithm>
#include <array>

#include "core/mechanism/document_format/element_members.h"
#include "core/mechanism/model/edits.h"
#include "core/mechanism/model/fresh_ids.h"
#include "core/mechanism/model/load_edits.h"
#include "core/mechanism/model/shift_edits.h"
#include "core/mechanism/model/validate.h"
#include "core/theory/states/state_edits.h"

namespace geargraph::cli {
namespace {

Diagnostic notFound(std::string_view id, ElementKind kind) {
  return {Code::unknownId,
          "There is no \"" + std::string(id) + "\" in " + std::string(listName(kind)) + ".",
          {{kind, Atom(id)}},
          {}};
}

MemberFilter unreadOf(const EditMembers& of) {
  return [&of](std::string_view name) { return of.isUnread(name); };
}

/// Changes the last element of a list, which the edit has added.
template <class List>
Expected<Mechanism> withRestOfLast(Expected<Mechanism> made, List Mechanism::*list, const EditMembers& of) {
  if (!made || of.problem()) return made;
  Mechanism mechanism = std::move(made).value();
  auto changed = withMembers((mechanism.*list).back(), of.json(), unreadOf(of), of.pointer());
  if (!changed) return changed.error();
  (mechanism.*list).back() = std::move(changed).value();
  return mechanism;
}

/// Changes the element of a list that has this id (or name).
template <class List>
Expected<Mechanism> withRestOf(Mechanism mechanism, List Mechanism::*list, ElementKind kind,
                               const std::string& id, const EditMembers& of) {
  for (auto& element : mechanism.*list) {
    bool isIt = false;
    if constexpr (requires { element.id; }) {
      isIt = element.id.text() == id;
    } else {
      isIt = element.name == id;
    }
    if (!isIt) continue;
    auto changed = withMembers(element, of.json(), unreadOf(of), of.pointer());
    if (!changed) return changed.error();
    element = std::move(changed).value();
    return mechanism;
  }
  return notFound(id, kind);
}

/// A new element of which nothing is known but its members.
template <class Element>
Expected<Element> elementOf(const EditMembers& of) {
  return elementFrom<Element>(of.json(), unreadOf(of), of.pointer());
}

std::optional<int> statePosition(const Mechanism& mechanism, std::string_view name) {
  for (std::size_t i = 0; i < mechanism.states.size(); ++i) {
    if (mechanism.states[i].name == name) return static_cast<int>(i);
  }
  return std::nullopt;
}

// What each edit takes. Members of elements are those of the document.

constexpr std::string_view kLinkId = "id of a link";
constexpr std::string_view kText = "text";
constexpr std::string_view kNumber = "number";
constexpr std::string_view kThree = "three numbers";
constexpr std::string_view kFlag = "true or false";
constexpr std::string_view kTeeth = "whole number from 1 to 100000";
constexpr std::string_view kIds = "list of ids";
constexpr std::string_view kNewId = "id; without it a free one";

constexpr std::array kLinkMembers = {ServedMember{"id", kNewId},
                                     ServedMember{"name", kText},
                                     ServedMember{"pinned", kFlag},
                                     ServedMember{"mass", "number, kg"},
                                     ServedMember{"centerOfMass", kThree},
                                     ServedMember{"inertia", "six numbers, kg m2"},
                                     ServedMember{"shapes", "list of 3D files"}};
constexpr std::array kAxisMembers = {ServedMember{"id", kNewId}, ServedMember{"point", kThree},
                                     ServedMember{"direction", kThree}, ServedMember{"pinned", kFlag}};
constexpr std::array kJointMembers = {ServedMember{"tail", kLinkId, true},
                                      ServedMember{"head", kLinkId, true},
                                      ServedMember{"axis", "id of an axis; without it a new one"},
                                      ServedMember{"id", kNewId},
                                      ServedMember{"offset", kNumber},
                                      ServedMember{"limits", "two of number or null, degrees"}};
constexpr std::array kMeshMembers = {ServedMember{"tail", kLinkId, true},
                                     ServedMember{"head", kLinkId, true},
                                     ServedMember{"tailTeeth", kTeeth, true},
                                     ServedMember{"headTeeth", kTeeth, true},
                                     ServedMember{"id", kNewId},
                                     ServedMember{"kind", "external, internal or bevel"},
                                     ServedMember{"pitchPoint", kThree},
                                     ServedMember{"faceWidth", kNumber},
                                     ServedMember{"tailWheel", "id of a wheel"},
                                     ServedMember{"headWheel", "id of a wheel"},
                                     ServedMember{"efficiency", kNumber},
                                     ServedMember{"friction", kNumber},
                                     ServedMember{"pinned", kFlag}};
constexpr std::array kWheelMembers = {ServedMember{"link", kLinkId, true}, ServedMember{"id", kNewId},
                                      ServedMember{"profileShift", kNumber}, ServedMember{"bore", kNumber},
                                      ServedMember{"backlash", kNumber}};
constexpr std::array kCouplingMembers = {ServedMember{"kind", "brake or clutch", true},
                                         ServedMember{"id", "id; without it a free letter"},
                                         ServedMember{"link", "id of the link that a brake holds"},
                                         ServedMember{"links", "ids of the two links of a clutch"}};
constexpr std::array kStateMembers = {ServedMember{"name", "text; without it a free number"},
                                      ServedMember{"engaged", kIds}, ServedMember{"drive", kLinkId},
                                      ServedMember{"driven", kLinkId}};
constexpr std::array kLoadMembers = {ServedMember{"id", kNewId},
                                     ServedMember{"joint", "id of a turning joint"},
                                     ServedMember{"link", kLinkId},
                                     ServedMember{"axis", "id of an axis"},
                                     ServedMember{"torque", "number, N m"},
                                     ServedMember{"force", "three numbers, N"},
                                     ServedMember{"point", kThree}};

/// Members of an element, with the one that names it in place of a new id, none of them needed.
template <std::size_t count>
constexpr std::array<ServedMember, count> changesOf(const std::array<ServedMember, count>& members,
                                                    std::string_view replaced, const ServedMember& named) {
  std::array<ServedMember, count> changes{};
  changes[0] = named;
  std::size_t next = 1;
  for (const ServedMember& member : members) {
    if (member.name != replaced) changes.at(next++) = {member.name, member.value, false};
  }
  return changes;
}

constexpr auto kLinkChanges = changesOf(kLinkMembers, "id", {"link", kLinkId, true});
constexpr auto kJointChanges = changesOf(kJointMembers, "id", {"joint", "id of a turning joint", true});
constexpr auto kMeshChanges = changesOf(kMeshMembers, "id", {"mesh", "id of a gear mesh", true});
constexpr auto kWheelChanges = changesOf(kWheelMembers, "id", {"wheel", "id of a wheel", true});
constexpr auto kCouplingChanges = changesOf(kCouplingMembers, "id", {"coupling", "id of a coupling", true});
constexpr auto kStateChanges = changesOf(kStateMembers, "name", {"state", "name of a state", true});
constexpr auto kLoadChanges = changesOf(kLoadMembers, "id", {"load", "id of a load", true});
constexpr std::array kDocumentChanges = {ServedMember{"name", kText},
                                         ServedMember{"notes", kText},
                                         ServedMember{"unit", kText},
                                         ServedMember{"gearDefaults", "object, as in a document"},
                                         ServedMember{"balances", "list, as in a document"},
                                         ServedMember{"sharing", "none or stiffness"},
                                         ServedMember{"driveTorque", "number, N m"},
                                         ServedMember{"density", "number, kg/m3"},
                                         ServedMember{"gravity", "three numbers, m/s2"}};
constexpr std::array kRemoved = {ServedMember{"links", kIds},      ServedMember{"turningJoints", kIds},
                                 ServedMember{"gearMeshes", kIds}, ServedMember{"wheels", kIds},
                                 ServedMember{"couplings", kIds},  ServedMember{"states", "list of names"},
                                 ServedMember{"loads", kIds}};
constexpr std::array kTeethMembers = {ServedMember{"mesh", "id of a gear mesh", true},
                                      ServedMember{"tailTeeth", kTeeth, true},
                                      ServedMember{"headTeeth", kTeeth, true}};
constexpr std::array kPointMembers = {ServedMember{"mesh", "id of a gear mesh", true},
                                      ServedMember{"point", "three numbers; none: from axes and teeth"}};
constexpr std::array kPlaceMembers = {ServedMember{"axis", "id of an axis", true},
                                      ServedMember{"point", "three numbers; none: placed by the teeth"},
                                      ServedMember{"direction", "three numbers; none: placed by the teeth"},
                                      ServedMember{"pinned", kFlag}};
constexpr std::array kInputsMembers = {ServedMember{"inputs", "list of objects with joint and speed", true}};
constexpr std::array kEngageMembers = {ServedMember{"couplings", kIds, true}};
constexpr std::array kEngageStateMembers = {ServedMember{"state", "name of a state", true}};
constexpr std::array kRenameMembers = {ServedMember{"link", kLinkId, true},
                                       ServedMember{"name", kText, true}};

Expected<Mechanism> addLink(Mechanism m, EditMembers& of) {
  auto next = withLink(std::move(m), {}, of.text("name"));
  if (!next) return next;
  Mechanism made = std::move(next).value();
  made.view.nodes.erase(made.links.back().id);  // drawings lay it out
  return withRestOfLast(std::move(made), &Mechanism::links, of);
}

Expected<Mechanism> addAxis(Mechanism m, EditMembers& of) {
  auto read = elementOf<Axis>(of);
  if (!read) return read.error();
  Axis axis = std::move(read).value();
  if (axis.id.empty()) axis.id = freshAxisIds(m, 1).front();
  m.axes.push_back(std::move(axis));
  return m;
}

Expected<Mechanism> addTurningJoint(Mechanism m, EditMembers& of) {
  const LinkId tail(of.text("tail")), head(of.text("head"));
  return withRestOfLast(withTurningJoint(std::move(m), tail, head, AxisId(of.text("axis"))),
                        &Mechanism::turningJoints, of);
}

Expected<Mechanism> addGearMesh(Mechanism m, EditMembers& of) {
  const LinkId tail(of.text("tail")), head(of.text("head"));
  const int tailTeeth = of.whole("tailTeeth"), headTeeth = of.whole("headTeeth");
  return withRestOfLast(withGearMesh(std::move(m), tail, head, tailTeeth, headTeeth), &Mechanism::gearMeshes,
                        of);
}

Expected<Mechanism> addWheel(Mechanism m, EditMembers& of) {
  auto read = elementOf<Wheel>(of);
  if (!read) return read.error();
  Wheel wheel = std::move(read).value();
  if (wheel.id.empty()) wheel.id = WheelId(freshId(m));
  m.wheels.push_back(std::move(wheel));
  return m;
}

Expected<Mechanism> addCoupling(Mechanism m, EditMembers& of) {
  const auto coupling = elementOf<Coupling>(of);
  if (!coupling) return coupling.error();
  const std::vector<LinkId>& links = coupling->links;
  if (coupling->kind == CouplingKind::brake)
    return withBrake(std::move(m), links.front(), coupling->id.text());
  if (links.size() != 2) return Diagnostic{Code::schema, "A clutch names two links.", {}, {}};
  return withClutch(std::move(m), links[0], links[1], coupling->id.text());
}

Expected<Mechanism> addLoad(Mechanism m, EditMembers& of) {
  auto load = elementOf<Load>(of);
  if (!load) return load.error();
  return withLoad(std::move(m), std::move(load).value());
}

/// What is removed, by its lists as in a document: {"links": ["3"], "gearMeshes": ["15"]}.
Expected<Mechanism> removeElements(Mechanism m, EditMembers& of) {
  constexpr std::array kKinds = {ElementKind::link,  ElementKind::turningJoint, ElementKind::gearMesh,
                                 ElementKind::wheel, ElementKind::coupling,     ElementKind::load};
  std::vector<ElementId> elements;
  for (const ElementKind kind : kKinds) {
    for (const std::string& id : of.texts(listName(kind))) elements.emplace_back(kind, Atom(id));
  }
  for (const std::string& name : of.texts("states")) {
    const auto position = statePosition(m, name);
    if (!position) return notFound(name, ElementKind::state);
    auto next = withoutState(std::move(m), *position);
    if (!next) return next;
    m = std::move(next).value();
  }
  return withoutElements(std::move(m), elements);
}

Expected<Mechanism> setAxis(Mechanism m, EditMembers& of) {
  const std::string axis = of.text("axis");
  auto placed = withAxisPlaced(std::move(m), AxisId(axis), of.triple("point"), of.triple("direction"));
  if (!placed || of.problem()) return placed;
  return withRestOf(std::move(placed).value(), &Mechanism::axes, ElementKind::axis, axis, of);
}

Expected<Mechanism> engageState(Mechanism m, EditMembers& of) {
  const std::string name = of.text("state");
  const auto position = statePosition(m, name);
  if (!position) return notFound(name, ElementKind::state);
  return withStateEngaged(std::move(m), *position);
}

constexpr std::array kEdits = {
    ServedEdit{"addLink", kLinkMembers, addLink},
    ServedEdit{"addAxis", kAxisMembers, addAxis},
    ServedEdit{"addTurningJoint", kJointMembers, addTurningJoint},
    ServedEdit{"addGearMesh", kMeshMembers, addGearMesh},
    ServedEdit{"addWheel", kWheelMembers, addWheel},
    ServedEdit{"addCoupling", kCouplingMembers, addCoupling},
    ServedEdit{"addState", kStateMembers,
               [](Mechanism m, EditMembers& of) {
                 return withRestOfLast(withState(std::move(m)), &Mechanism::states, of);
               }},
    ServedEdit{"addLoad", kLoadMembers, addLoad},
    ServedEdit{"remove", kRemoved, removeElements},
    ServedEdit{"setDocument", kDocumentChanges,
               [](Mechanism m, EditMembers& of) { return withDocumentMembers(m, of.json(), unreadOf(of)); }},
    ServedEdit{"setLink", kLinkChanges,
               [](Mechanism m, EditMembers& of) {
                 const std::string link = of.text("link");
                 return withRestOf(std::move(m), &Mechanism::links, ElementKind::link, link, of);
               }},
    ServedEdit{"setAxis", kPlaceMembers, setAxis},
    ServedEdit{"setTurningJoint", kJointChanges,
               [](Mechanism m, EditMembers& of) {
                 const std::string joint = of.text("joint");
                 return withRestOf(std::move(m), &Mechanism::turningJoints, ElementKind::turningJoint, joint,
                                   of);
               }},
    ServedEdit{"setGearMesh", kMeshChanges,
               [](Mechanism m, EditMembers& of) {
                 const std::string mesh = of.text("mesh");
                 return withRestOf(std::move(m), &Mechanism::gearMeshes, ElementKind::gearMesh, mesh, of);
               }},
    ServedEdit{"setTeeth", kTeethMembers,
               [](Mechanism m, EditMembers& of) {
                 const MeshId mesh(of.text("mesh"));
                 const int tailTeeth = of.whole("tailTeeth"), headTeeth = of.whole("headTeeth");
                 return withTeeth(std::move(m), mesh, tailTeeth, headTeeth);
               }},
    ServedEdit{"setPitchPoint", kPointMembers,
               [](Mechanism m, EditMembers& of) {
                 const MeshId mesh(of.text("mesh"));
                 return withPitchPoint(std::move(m), mesh, of.triple("point"));
               }},
    ServedEdit{"setWheel", kWheelChanges,
               [](Mechanism m, EditMembers& of) {
                 const std::string wheel = of.text("wheel");
                 return withRestOf(std::move(m), &Mechanism::wheels, ElementKind::wheel, wheel, of);
               }},
    ServedEdit{"setCoupling", kCouplingChanges,
               [](Mechanism m, EditMembers& of) {
                 const std::string coupling = of.text("coupling");
                 return withRestOf(std::move(m), &Mechanism::couplings, ElementKind::coupling, coupling, of);
               }},
    ServedEdit{"setState", kStateChanges,
               [](Mechanism m, EditMembers& of) {
                 const std::string state = of.text("state");
                 return withRestOf(std::move(m), &Mechanism::states, ElementKind::state, state, of);
               }},
    ServedEdit{"setLoad", kLoadChanges,
               [](Mechanism m, EditMembers& of) {
                 const std::string load = of.text("load");
                 return withRestOf(std::move(m), &Mechanism::loads, ElementKind::load, load, of);
               }},
    ServedEdit{"setInputs", kInputsMembers,
               [](Mechanism m, EditMembers& of) { return withInputs(std::move(m), of.inputs("inputs")); }},
    ServedEdit{"engage", kEngageMembers,
               [](Mechanism m, EditMembers& of) {
                 const std::vector<std::string> names = of.texts("couplings");
                 return withCouplingsEngaged(std::move(m), {names.begin(), names.end()});
               }},
    ServedEdit{"engageState", kEngageStateMembers, engageState},
    ServedEdit{"rename", kRenameMembers,
               [](Mechanism m, EditMembers& of) {
                 const LinkId link(of.text("link"));
                 return withName(std::move(m), link, of.text("name"));
               }},
};

/// The document after one edit.
Expected<Mechanism> withServedEdit(const Mechanism& mechanism, const JsonValue& edit,
                                   const std::string& pointer) {
  const auto name = edit.is(JsonKind::object) ? edit.member("edit") : std::nullopt;
  const auto found = std::find_if(kEdits.begin(), kEdits.end(), [&](const ServedEdit& served) {
    return name && name->is(JsonKind::string) && name->equals(served.name);
  });
  if (found == kEdits.end())
    return Diagnostic{Code::schema, "An edit is one of " + servedEditNames() + ".", {}, pointer};
  if (auto sentence = unknownMember(found->name, edit, found->members, "edit"))
    return Diagnostic{Code::schema, *std::move(sentence), {}, pointer};
  EditMembers members(edit, found->members, pointer);
  auto next = found->apply(mechanism, members);
  if (members.problem()) return *members.problem();
  if (next) return next;
  Diagnostics problems = next.error();
  if (!problems.front().pointer.starts_with(pointer)) problems.front().pointer = pointer;
  return problems;
}

}  // namespace

std::span<const ServedEdit> servedEdits() {
  return kEdits;
}

std::string servedEditNames() {
  std::string names;
  for (const ServedEdit& edit : kEdits) names += (names.empty() ? "" : ", ") + std::string(edit.name);
  return names;
}

Expected<Mechanism> withServedEdits(Mechanism mechanism, const JsonValue& edits) {
  std::optional<Diagnostics> problems;
  edits.forEachElement([&](const JsonValue& edit, std::size_t position) {
    if (problems) return;
    auto next = withServedEdit(mechanism, edit, "/params/edits/" + std::to_string(position));
    if (next) {
      mechanism = std::move(next).value();
    } else {
      problems = next.error();
    }
  });
  if (!problems) {
    Diagnostics wrong = wellFormedDiagnostics(mechanism);
    if (wrong.empty()) return mechanism;
    problems = std::move(wrong);
  }
  return *std::move(problems);
}

}  // namespace geargraph::cli
