#include "core/presentation/requests/document_edits.h"

#include <algorithm>
#include <array>

#include "core/mechanism/document_format/element_members.h"
#include "core/mechanism/model/edits.h"
#include "core/mechanism/model/fresh_ids.h"
#include "core/mechanism/model/link_edits.h"
#include "core/mechanism/model/load_edits.h"
#include "core/mechanism/model/member_info.h"
#include "core/mechanism/model/shift_edits.h"
#include "core/mechanism/model/validate.h"
#include "core/theory/states/state_edits.h"
#include "core/theory/states/weld_edits.h"

namespace geargraph {
namespace {

Diagnostic notFound(std::string_view id, ElementKind kind) {
  return {Code::unknownId,
          "There is no \"" + std::string(id) + "\" in " + std::string(listName(kind)) + ".",
          {{kind, InternedString(id)}},
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

// What each edit takes. Members of elements are those of the document, as they are described (fields.h).

using RequestMembers = std::vector<RequestMember>;

constexpr std::string_view kLinkId = "id of a link";
constexpr std::string_view kText = "text";
constexpr std::string_view kThree = "three numbers";
constexpr std::string_view kFlag = "true or false";
constexpr std::string_view kTeeth = "whole number from 1 to 100000";
constexpr std::string_view kIds = "list of ids";
constexpr std::string_view kNewId = "id; without it a free one";

/// With the unit, where it is one of physics.
std::string_view withUnit(std::string_view value, Measure measure) {
  const std::string_view unit = measure == Measure::modules ? std::string_view() : unitOf(measure);
  if (unit.empty()) return value;
  return InternedString(std::string(value) + ", " + std::string(unit))
      .text();  // lives as long as the program
}

std::string_view referenceText(ElementKind kind) {
  switch (kind) {
    case ElementKind::link:
      return kLinkId;
    case ElementKind::axis:
      return "id of an axis";
    case ElementKind::turningJoint:
      return "id of a turning joint";
    case ElementKind::gearMesh:
      return "id of a gear mesh";
    case ElementKind::wheel:
      return "id of a wheel";
    case ElementKind::coupling:
      return "id of a coupling";
    default:
      return "id";
  }
}

/// What a member of the document holds, for the help.
std::string_view valueText(const MemberInfo& info) {
  switch (info.value) {
    case MemberValue::constant:
    case MemberValue::text:
    case MemberValue::shortText:
      return kText;
    case MemberValue::id:
      return kNewId;
    case MemberValue::reference:
      return referenceText(info.target);
    case MemberValue::references:
      return kIds;
    case MemberValue::flag:
      return kFlag;
    case MemberValue::teeth:
      return kTeeth;
    case MemberValue::meshKind:
      return "external, internal, bevel, belt, pins, rack, screw, crossedHelical, worm, faceGear or hypoid";
    case MemberValue::jointKind:
      return "turning or sliding";
    case MemberValue::hand:
      return "right or left";
    case MemberValue::couplingKind:
      return "brake, clutch or freewheel";
    case MemberValue::sharing:
      return "none or stiffness";
    case MemberValue::number:
    case MemberValue::measure:
      return withUnit("number", info.measure);
    case MemberValue::triple:
    case MemberValue::position:
      return withUnit(kThree, info.measure);
    case MemberValue::inertia:
      return withUnit("six numbers", info.measure);
    case MemberValue::ends:
      return withUnit("two of number or null", info.measure);
    case MemberValue::place:
      return "two numbers";
    case MemberValue::object:
    case MemberValue::places:
    case MemberValue::numbersOfLinks:
      return "object, as in a document";
    case MemberValue::objects:
      return info.part == DocumentPart::shape ? "list of 3D files" : "list, as in a document";
  }
  return kText;
}

/// The members that an edit adds an element with: those that a document needs first. `but`: what the edit
/// says otherwise about some of them.
RequestMembers membersFor(DocumentPart part, const RequestMembers& but = {}) {
  RequestMembers members;
  const std::span<const MemberInfo> listed = listedMembersOf(part);
  for (const bool isFirst : {true, false}) {
    for (const MemberInfo& info : listed) {
      const bool isNeeded = info.isNeeded && info.value != MemberValue::id;
      if (isNeeded != isFirst) continue;
      const auto other = std::find_if(but.begin(), but.end(),
                                      [&](const RequestMember& each) { return each.name == info.name; });
      members.push_back(other != but.end() ? *other : RequestMember{info.name, valueText(info), isNeeded});
    }
  }
  return members;
}

/// Members of an element, with the one that names it in place of a new id, none of them needed.
RequestMembers changesOf(const RequestMembers& members, std::string_view replaced,
                         const RequestMember& named) {
  RequestMembers changes{named};
  for (const RequestMember& member : members) {
    if (member.name != replaced) changes.push_back({member.name, member.value, false});
  }
  return changes;
}

/// The members of the document itself: all but those with edits of their own, and the editor's view.
RequestMembers documentChanges() {
  constexpr auto kWithEdits = std::to_array<std::string_view>(
      {"format", "version", "links", "axes", "turningJoints", "gearMeshes", "wheels", "inputs", "couplings",
       "states", "engaged", "loads", "view"});
  RequestMembers changes;
  for (const MemberInfo& info : listedMembersOf(DocumentPart::document)) {
    if (std::find(kWithEdits.begin(), kWithEdits.end(), info.name) == kWithEdits.end())
      changes.push_back({info.name, valueText(info)});
  }
  return changes;
}

struct ElementEdits {
  RequestMembers link = membersFor(DocumentPart::link);
  RequestMembers axis = membersFor(DocumentPart::axis);
  RequestMembers joint =
      membersFor(DocumentPart::turningJoint, {{"axis", "id of an axis; without it a new one"}});
  RequestMembers mesh = membersFor(DocumentPart::gearMesh);
  RequestMembers wheel = membersFor(DocumentPart::wheel);
  RequestMembers coupling =
      membersFor(DocumentPart::coupling, {{"id", "id; without it a free letter"},
                                          {"link", "id of the link that a brake holds"},
                                          {"links", "ids of the two links of a clutch"}});
  RequestMembers state =
      membersFor(DocumentPart::state, {{"name", "text; without it a free number"}, {"engaged", kIds}});
  RequestMembers load = membersFor(DocumentPart::load);

  RequestMembers linkChanges = changesOf(link, "id", {"link", kLinkId, true});
  RequestMembers axisChanges =
      changesOf(membersFor(DocumentPart::axis, {{"point", "three numbers; none: placed by the teeth"},
                                                {"direction", "three numbers; none: placed by the teeth"}}),
                "id", {"axis", "id of an axis", true});
  RequestMembers jointChanges = changesOf(joint, "id", {"joint", "id of a turning joint", true});
  RequestMembers meshChanges = changesOf(mesh, "id", {"mesh", "id of a gear mesh", true});
  RequestMembers wheelChanges = changesOf(wheel, "id", {"wheel", "id of a wheel", true});
  RequestMembers couplingChanges = changesOf(coupling, "id", {"coupling", "id of a coupling", true});
  RequestMembers stateChanges = changesOf(state, "name", {"state", "name of a state", true});
  RequestMembers loadChanges = changesOf(load, "id", {"load", "id of a load", true});
  RequestMembers document = documentChanges();
};

const ElementEdits& elementEdits() {
  static const ElementEdits all;
  return all;
}

constexpr std::array kRemoved = {RequestMember{"links", kIds},      RequestMember{"turningJoints", kIds},
                                 RequestMember{"gearMeshes", kIds}, RequestMember{"wheels", kIds},
                                 RequestMember{"couplings", kIds},  RequestMember{"states", "list of names"},
                                 RequestMember{"loads", kIds}};
constexpr std::array kTeethMembers = {RequestMember{"mesh", "id of a gear mesh", true},
                                      RequestMember{"tailTeeth", kTeeth, true},
                                      RequestMember{"headTeeth", kTeeth, true}};
constexpr std::array kPointMembers = {RequestMember{"mesh", "id of a gear mesh", true},
                                      RequestMember{"point", "three numbers; none: from axes and teeth"}};
constexpr std::array kInputsMembers = {RequestMember{"inputs", "list of objects with joint and speed", true}};
constexpr std::array kEngageMembers = {RequestMember{"couplings", kIds, true}};
constexpr std::array kEngageStateMembers = {RequestMember{"state", "name of a state", true}};
constexpr std::array kRenameMembers = {RequestMember{"link", kLinkId, true},
                                       RequestMember{"name", kText, true}};

constexpr std::array kMergeMembers = {RequestMember{"link", kLinkId, true},
                                      RequestMember{"other", kLinkId, true}};
constexpr std::array kSplitMembers = {RequestMember{"link", kLinkId, true},
                                      RequestMember{"turningJoints", kIds}, RequestMember{"gearMeshes", kIds},
                                      RequestMember{"couplings", kIds}};

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
  const auto coupling = elementOf<ShiftElement>(of);
  if (!coupling) return coupling.error();
  const std::vector<LinkId>& links = coupling->links;
  if (coupling->kind == ShiftElementKind::brake)
    return withBrake(std::move(m), links.front(), coupling->id.text());
  if (links.size() != 2) return Diagnostic{Code::schema, "A clutch or freewheel names two links.", {}, {}};
  if (coupling->kind == ShiftElementKind::freewheel)
    return withFreewheel(std::move(m), links[0], links[1], coupling->id.text());
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
    for (const std::string& id : of.texts(listName(kind))) elements.emplace_back(kind, InternedString(id));
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

/// What the new link takes, by its lists as in a document; none: the side that was drawn last.
Expected<Mechanism> splitLink(Mechanism m, EditMembers& of) {
  const LinkId link(of.text("link"));
  std::vector<ElementId> moving;
  for (const ElementKind kind : {ElementKind::turningJoint, ElementKind::gearMesh, ElementKind::coupling}) {
    for (const std::string& id : of.texts(listName(kind))) moving.emplace_back(kind, InternedString(id));
  }
  if (moving.empty()) moving = lastSideOf(m, link);
  return withLinkDivided(m, link, moving);
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

std::vector<DocumentEdit> madeEdits(const ElementEdits& elements) {
  return {
      DocumentEdit{"addLink", elements.link, addLink},
      DocumentEdit{"addAxis", elements.axis, addAxis},
      DocumentEdit{"addTurningJoint", elements.joint, addTurningJoint},
      DocumentEdit{"addGearMesh", elements.mesh, addGearMesh},
      DocumentEdit{"addWheel", elements.wheel, addWheel},
      DocumentEdit{"addCoupling", elements.coupling, addCoupling},
      DocumentEdit{"addState", elements.state,
                   [](Mechanism m, EditMembers& of) {
                     return withRestOfLast(withState(std::move(m)), &Mechanism::states, of);
                   }},
      DocumentEdit{"addLoad", elements.load, addLoad},
      DocumentEdit{"remove", kRemoved, removeElements},
      DocumentEdit{
          "setDocument", elements.document,
          [](Mechanism m, EditMembers& of) { return withDocumentMembers(m, of.json(), unreadOf(of)); }},
      DocumentEdit{"setLink", elements.linkChanges,
                   [](Mechanism m, EditMembers& of) {
                     const std::string link = of.text("link");
                     return withRestOf(std::move(m), &Mechanism::links, ElementKind::link, link, of);
                   }},
      DocumentEdit{"setAxis", elements.axisChanges, setAxis},
      DocumentEdit{"setTurningJoint", elements.jointChanges,
                   [](Mechanism m, EditMembers& of) {
                     const std::string joint = of.text("joint");
                     return withRestOf(std::move(m), &Mechanism::turningJoints, ElementKind::turningJoint,
                                       joint, of);
                   }},
      DocumentEdit{"setGearMesh", elements.meshChanges,
                   [](Mechanism m, EditMembers& of) {
                     const std::string mesh = of.text("mesh");
                     return withRestOf(std::move(m), &Mechanism::gearMeshes, ElementKind::gearMesh, mesh, of);
                   }},
      DocumentEdit{"setTeeth", kTeethMembers,
                   [](Mechanism m, EditMembers& of) {
                     const MeshId mesh(of.text("mesh"));
                     const int tailTeeth = of.whole("tailTeeth"), headTeeth = of.whole("headTeeth");
                     return withTeeth(std::move(m), mesh, tailTeeth, headTeeth);
                   }},
      DocumentEdit{"setPitchPoint", kPointMembers,
                   [](Mechanism m, EditMembers& of) {
                     const MeshId mesh(of.text("mesh"));
                     return withPitchPoint(std::move(m), mesh, of.triple("point"));
                   }},
      DocumentEdit{"setWheel", elements.wheelChanges,
                   [](Mechanism m, EditMembers& of) {
                     const std::string wheel = of.text("wheel");
                     return withRestOf(std::move(m), &Mechanism::wheels, ElementKind::wheel, wheel, of);
                   }},
      DocumentEdit{"setCoupling", elements.couplingChanges,
                   [](Mechanism m, EditMembers& of) {
                     const std::string coupling = of.text("coupling");
                     return withRestOf(std::move(m), &Mechanism::couplings, ElementKind::coupling, coupling,
                                       of);
                   }},
      DocumentEdit{"setState", elements.stateChanges,
                   [](Mechanism m, EditMembers& of) {
                     const std::string state = of.text("state");
                     return withRestOf(std::move(m), &Mechanism::states, ElementKind::state, state, of);
                   }},
      DocumentEdit{"setLoad", elements.loadChanges,
                   [](Mechanism m, EditMembers& of) {
                     const std::string load = of.text("load");
                     return withRestOf(std::move(m), &Mechanism::loads, ElementKind::load, load, of);
                   }},
      DocumentEdit{
          "setInputs", kInputsMembers,
          [](Mechanism m, EditMembers& of) { return withInputs(std::move(m), of.inputs("inputs")); }},
      DocumentEdit{"engage", kEngageMembers,
                   [](Mechanism m, EditMembers& of) {
                     const std::vector<std::string> names = of.texts("couplings");
                     return withCouplingsEngaged(std::move(m), {names.begin(), names.end()});
                   }},
      DocumentEdit{"engageState", kEngageStateMembers, engageState},
      DocumentEdit{"rename", kRenameMembers,
                   [](Mechanism m, EditMembers& of) {
                     const LinkId link(of.text("link"));
                     return withName(std::move(m), link, of.text("name"));
                   }},
      DocumentEdit{"mergeLinks", kMergeMembers,
                   [](Mechanism m, EditMembers& of) {
                     const LinkId link(of.text("link"));
                     return withLinksWelded(m, link, LinkId(of.text("other")));
                   }},
      DocumentEdit{"splitLink", kSplitMembers, splitLink},
  };
}

/// The document after one edit.
Expected<Mechanism> withDocumentEdit(const Mechanism& mechanism, const JsonValue& edit,
                                     const std::string& pointer) {
  const auto name = edit.is(JsonKind::object) ? edit.member("edit") : std::nullopt;
  const std::span<const DocumentEdit> edits = documentEdits();
  const auto found = std::find_if(edits.begin(), edits.end(), [&](const DocumentEdit& served) {
    return name && name->is(JsonKind::string) && name->equals(served.name);
  });
  if (found == edits.end())
    return Diagnostic{Code::schema, "An edit is one of " + documentEditNames() + ".", {}, pointer};
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

std::span<const DocumentEdit> documentEdits() {
  static const std::vector<DocumentEdit> edits = madeEdits(elementEdits());
  return edits;
}

std::string documentEditNames() {
  std::string names;
  for (const DocumentEdit& edit : documentEdits())
    names += (names.empty() ? "" : ", ") + std::string(edit.name);
  return names;
}

Expected<Mechanism> withDocumentEdits(Mechanism mechanism, const JsonValue& edits) {
  std::optional<Diagnostics> problems;
  edits.forEachElement([&](const JsonValue& edit, std::size_t position) {
    if (problems) return;
    auto next = withDocumentEdit(mechanism, edit, "/params/edits/" + std::to_string(position));
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

}  // namespace geargraph
