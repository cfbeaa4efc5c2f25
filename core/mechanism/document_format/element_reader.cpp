#include "core/mechanism/document_format/element_reader.h"

#include "core/foundations/base/words.h"
#include "core/mechanism/document_format/view_reader.h"

namespace geargraph::inline document_format {
namespace {

void readMass(JsonObject& from, Link& link) {
  const auto mass = from.number("mass");
  const auto center = from.triple("centerOfMass");
  const auto inertia = from.inertia("inertia");
  if (mass) link.mass = LinkMass{*mass, center, inertia};
  if (from.member("mass")) return;
  for (const char* const name : {"centerOfMass", "inertia"}) {
    if (const auto value = from.member(name)) from.wrong(name, *value, toTranslate("a \"mass\" beside it"));
  }
}

std::optional<MeshKind> meshKindOf(JsonObject& from) {
  const auto value = from.member("kind");
  if (!value) return std::nullopt;
  for (const MeshKind kind : {MeshKind::external, MeshKind::internal, MeshKind::bevel}) {
    if (value->is(JsonKind::string) && value->equals(meshKindName(kind))) return kind;
  }
  from.wrong("kind", *value, toTranslate("\"external\", \"internal\" or \"bevel\""));
  return std::nullopt;
}

/// The link where the object names one; else it has to name a joint.
std::optional<LinkId> oneOfJointAndLink(JsonObject& from) {
  const auto link = from.member("link");
  if (!link) return std::nullopt;
  if (from.member("joint")) from.wrong("link", *link, toTranslate("a joint or a link, not both"));
  return LinkId(from.requiredId("link"));
}

std::optional<AxisId> optionalAxis(JsonObject& from) {
  const auto axis = from.id("axis");
  return axis ? std::optional(AxisId(*axis)) : std::nullopt;
}

Number requiredTorque(JsonObject& from) {
  (void)from.required("torque", toTranslate("a torque in N m"));
  return from.number("torque").value_or(Number());
}

}  // namespace

void readMembers(JsonObject& from, Link& link) {
  link.name = from.shortText("name").value_or("");
  link.pinned = from.flag("pinned").value_or(false);
  readMass(from, link);
  const auto shapes = from.member("shapes");
  const std::string pointer = from.pointer() + "/shapes";
  if (!shapes || from.diagnostics().covers(pointer)) return;
  if (!shapes->is(JsonKind::array)) return from.wrong("shapes", *shapes, toTranslate("a list of 3D files"));
  link.shapes = readShapes(from.diagnostics(), *shapes, pointer, link.id);
}

void readMembers(JsonObject& from, Axis& axis) {
  axis.point = from.triple("point");
  axis.direction = from.triple("direction");
  axis.pinned = from.flag("pinned").value_or(false);
}

void readMembers(JsonObject& from, TurningJoint& joint) {
  joint.tail = LinkId(from.requiredId("tail"));
  joint.head = LinkId(from.requiredId("head"));
  joint.axis = AxisId(from.requiredId("axis"));
  joint.offset = from.number("offset").value_or(Number());
  if (const auto ends = from.ends("limits")) joint.limits = {(*ends)[0], (*ends)[1]};
}

void readMembers(JsonObject& from, GearMesh& mesh) {
  mesh.tail = LinkId(from.requiredId("tail"));
  mesh.head = LinkId(from.requiredId("head"));
  mesh.tailTeeth = from.requiredWhole("tailTeeth", kMinTeeth, kMaxTeeth);
  mesh.headTeeth = from.requiredWhole("headTeeth", kMinTeeth, kMaxTeeth);
  mesh.pitchPoint = from.triple("pitchPoint");
  mesh.kind = meshKindOf(from);
  mesh.faceWidth = from.number("faceWidth");
  if (const auto wheel = from.id("tailWheel")) mesh.tailWheel = WheelId(*wheel);
  if (const auto wheel = from.id("headWheel")) mesh.headWheel = WheelId(*wheel);
  mesh.pinned = from.flag("pinned").value_or(false);
  mesh.efficiency = from.number("efficiency");
  mesh.friction = from.number("friction");
}

void readMembers(JsonObject& from, Wheel& wheel) {
  wheel.link = LinkId(from.requiredId("link"));
  wheel.profileShift = from.number("profileShift");
  wheel.bore = from.number("bore");
  wheel.backlash = from.number("backlash");
}

void readMembers(JsonObject& from, Coupling& coupling) {
  const auto kind = from.required("kind", toTranslate("\"brake\" or \"clutch\""));
  const auto is = [&](std::string_view name) {
    return kind && kind->is(JsonKind::string) && kind->equals(name);
  };
  if (is("brake")) {
    coupling.kind = CouplingKind::brake;
    coupling.links = {LinkId(from.requiredId("link"))};
  } else if (is("clutch")) {
    coupling.kind = CouplingKind::clutch;
    (void)from.required("links", toTranslate("a list of two ids of links"));
    for (const Atom id : from.ids("links").value_or(std::vector<Atom>{})) coupling.links.emplace_back(id);
  } else if (kind) {
    from.wrong("kind", *kind, toTranslate("\"brake\" or \"clutch\""));
  }
}

void readMembers(JsonObject& from, ShiftState& state) {
  (void)from.required("name", toTranslate("the name of the state"));
  state.name = from.shortText("name").value_or("");
  (void)from.required("engaged", toTranslate("a list of ids of couplings"));
  for (const Atom id : from.ids("engaged").value_or(std::vector<Atom>{})) state.engaged.emplace_back(id);
  if (const auto link = from.id("drive")) state.drive = LinkId(*link);
  if (const auto link = from.id("driven")) state.driven = LinkId(*link);
}

void readMembers(JsonObject& from, Load& load) {
  const auto link = oneOfJointAndLink(from);
  if (!link) {
    const JointId joint(from.requiredId("joint"));
    load.action = JointTorque{joint, requiredTorque(from)};
    return;
  }
  const auto force = from.member("force");
  if (!force) {
    const std::optional<AxisId> axis = optionalAxis(from);
    load.action = LinkTorque{*link, axis, requiredTorque(from)};
    return;
  }
  if (const auto both = from.member("torque"))
    from.wrong("torque", *both, toTranslate("a torque or a force, not both in one load"));
  (void)from.required("point", toTranslate("the point of the link that the force acts at"));
  LinkForce action{*link, {}, {}};
  if (const auto components = from.triple("force")) action.force = *components;
  if (const auto point = from.triple("point")) action.point = *point;
  load.action = action;
}

void readMembers(JsonObject& from, Balance& balance) {
  if (const auto link = oneOfJointAndLink(from)) {
    balance.at = Balance::OnLink{*link, optionalAxis(from)};
  } else {
    balance.at = JointId(from.requiredId("joint"));
  }
}

void readMembers(JsonObject& from, GearDefaults& defaults) {
  defaults.pressureAngle = from.number("pressureAngle");
  defaults.backlash = from.number("backlash");
  defaults.faceWidth = from.number("faceWidth");
  defaults.efficiency = from.number("efficiency");
  defaults.friction = from.number("friction");
}

}  // namespace geargraph::inline document_format
