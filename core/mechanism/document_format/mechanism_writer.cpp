#include <algorithm>

#include "core/foundations/files/json.h"
#include "core/foundations/files/json_writer.h"
#include "core/mechanism/document_format/element_members.h"
#include "core/mechanism/document_format/mechanism_file.h"

namespace geargraph::inline document_format {
namespace {

using Layout = JsonWriter::Layout;

/// Writes the members of a document in the order of the format.
class MechanismWriter {
 public:
  explicit MechanismWriter(ByteSink& sink) : m_json(sink) {}

  void document(const Mechanism& mechanism) {
    m_json.beginObject();
    m_json.member("format", "geargraph");
    m_json.member("version", kFileVersion);
    if (!mechanism.name.empty()) m_json.member("name", mechanism.name);
    if (!mechanism.notes.empty()) m_json.member("notes", mechanism.notes);
    m_json.member("unit", mechanism.unit);
    list("links", mechanism.links);
    list("axes", mechanism.axes);
    list("turningJoints", mechanism.turningJoints);
    list("gearMeshes", mechanism.gearMeshes);
    if (!mechanism.wheels.empty()) list("wheels", mechanism.wheels);
    if (mechanism.gearDefaults) element("gearDefaults", *mechanism.gearDefaults);
    if (mechanism.inputs) list("inputs", *mechanism.inputs);
    if (!mechanism.couplings.empty()) list("couplings", mechanism.couplings);
    if (!mechanism.states.empty()) list("states", mechanism.states);
    if (!mechanism.engaged.empty()) ids("engaged", mechanism.engaged);
    if (!mechanism.loads.empty()) list("loads", mechanism.loads);
    if (mechanism.balances) list("balances", *mechanism.balances);
    if (mechanism.sharing) m_json.member("sharing", loadSharingName(*mechanism.sharing));
    number("driveTorque", mechanism.driveTorque);
    number("density", mechanism.density);
    triple("gravity", mechanism.gravity);
    view(mechanism);
    unknown(mechanism.unknown);
    m_json.endObject();
  }

  template <class Element>
  void object(const Element& element) {
    m_json.beginObject(Layout::row);
    members(element);
    unknown(element.unknown);
    m_json.endObject();
  }

 private:
  template <class Element>
  void list(std::string_view name, const std::vector<Element>& elements) {
    m_json.key(name);
    m_json.beginArray();
    for (const Element& element : elements) object(element);
    m_json.endArray();
  }

  template <class Element>
  void element(std::string_view name, const Element& element) {
    m_json.key(name);
    object(element);
  }

  void members(const Link& link) {
    id("id", link.id);
    if (!link.name.empty()) m_json.member("name", link.name);
    pinned(link.pinned);
    if (link.mass) mass(*link.mass);
    if (link.shapes.empty()) return;
    m_json.key("shapes");
    m_json.beginArray(Layout::row);
    for (const LinkShape& shape : link.shapes) object(shape);
    m_json.endArray();
  }

  void mass(const LinkMass& mass) {
    number("mass", mass.mass);
    triple("centerOfMass", mass.center);
    if (!mass.inertia) return;
    m_json.key("inertia");
    m_json.beginArray(Layout::row);
    for (const Number& number : *mass.inertia) value(number);
    m_json.endArray();
  }

  void members(const LinkShape& shape) {
    m_json.member("file", shape.file);
    triple("position", shape.position);
    triple("orientation", shape.orientation);
    number("scale", shape.scale);
  }

  void members(const Axis& axis) {
    id("id", axis.id);
    triple("point", axis.point);
    triple("direction", axis.direction);
    pinned(axis.pinned);
  }

  void members(const TurningJoint& joint) {
    id("id", joint.id);
    id("tail", joint.tail);
    id("head", joint.head);
    id("axis", joint.axis);
    number("offset", joint.offset);
    limits(joint.limits);
  }

  void members(const GearMesh& mesh) {
    id("id", mesh.id);
    id("tail", mesh.tail);
    id("head", mesh.head);
    m_json.member("tailTeeth", mesh.tailTeeth);
    m_json.member("headTeeth", mesh.headTeeth);
    triple("pitchPoint", mesh.pitchPoint);
    if (mesh.kind) m_json.member("kind", meshKindName(*mesh.kind));
    number("faceWidth", mesh.faceWidth);
    if (mesh.tailWheel) id("tailWheel", *mesh.tailWheel);
    if (mesh.headWheel) id("headWheel", *mesh.headWheel);
    pinned(mesh.pinned);
    number("efficiency", mesh.efficiency);
    number("friction", mesh.friction);
  }

  void members(const Wheel& wheel) {
    id("id", wheel.id);
    id("link", wheel.link);
    number("profileShift", wheel.profileShift);
    number("bore", wheel.bore);
    number("backlash", wheel.backlash);
  }

  void members(const GearDefaults& defaults) {
    number("pressureAngle", defaults.pressureAngle);
    number("backlash", defaults.backlash);
    number("faceWidth", defaults.faceWidth);
    number("efficiency", defaults.efficiency);
    number("friction", defaults.friction);
  }

  void members(const Input& input) {
    id("joint", input.joint);
    number("speed", input.speed);
  }

  void members(const Coupling& coupling) {
    id("id", coupling.id);
    const bool isBrake = coupling.kind == CouplingKind::brake;
    m_json.member("kind", std::string_view(isBrake ? "brake" : "clutch"));
    if (isBrake) {
      id("link", coupling.links.front());
    } else {
      ids("links", coupling.links);
    }
  }

  void members(const ShiftState& state) {
    m_json.member("name", state.name);
    ids("engaged", state.engaged);
    if (state.drive) id("drive", *state.drive);
    if (state.driven) id("driven", *state.driven);
  }

  void members(const Load& load) {
    if (!load.id.empty()) id("id", load.id);
    if (const auto* inJoint = std::get_if<JointTorque>(&load.action)) {
      id("joint", inJoint->joint);
      number("torque", inJoint->torque);
    } else if (const auto* torque = std::get_if<LinkTorque>(&load.action)) {
      id("link", torque->link);
      if (torque->axis) id("axis", *torque->axis);
      number("torque", torque->torque);
    } else {
      const auto& force = std::get<LinkForce>(load.action);
      id("link", force.link);
      triple("force", force.force);
      triple("point", force.point);
    }
  }

  void members(const Balance& balance) {
    if (const auto* joint = std::get_if<JointId>(&balance.at)) {
      id("joint", *joint);
      return;
    }
    const auto& onLink = std::get<Balance::OnLink>(balance.at);
    id("link", onLink.link);
    if (onLink.axis) id("axis", *onLink.axis);
  }

  void members(const SheetNote& note) {
    id("id", note.id);
    m_json.member("text", note.text);
    m_json.key("at");
    place(note.at);
  }

  void members(const ViewCamera& camera) {
    m_json.key("target");
    m_json.beginArray(Layout::row);
    for (const double coordinate : camera.target) m_json.number(coordinate);
    m_json.endArray();
    m_json.member("azimuth", camera.azimuth);
    m_json.member("elevation", camera.elevation);
    m_json.member("distance", camera.distance);
  }

  void view(const Mechanism& mechanism) {
    const View& view = mechanism.view;
    if (view == View{}) return;
    m_json.key("view");
    m_json.beginObject();
    nodes("nodes", view.nodes, mechanism.links);
    nodes("ttNodes", view.ttNodes, mechanism.links);
    if (!view.notes.empty()) list("notes", view.notes);
    if (view.camera) element("camera", *view.camera);
    colors(view.colors, mechanism.links);
    unknown(view.unknown);
    m_json.endObject();
  }

  /// Nodes in the order of the links, so that a saved file reads like its list of links.
  void nodes(std::string_view name, std::map<LinkId, SheetPoint> nodes, const std::vector<Link>& links) {
    if (nodes.empty()) return;
    m_json.key(name);
    m_json.beginObject();
    for (const Link& link : links) {
      const auto node = nodes.find(link.id);
      if (node == nodes.end()) continue;
      point(*node);
      nodes.erase(node);
    }
    for (const auto& node : nodes) point(node);
    m_json.endObject();
  }

  void colors(std::map<LinkId, int> colors, const std::vector<Link>& links) {
    if (colors.empty()) return;
    m_json.key("colors");
    m_json.beginObject(Layout::row);
    for (const Link& link : links) {
      const auto color = colors.find(link.id);
      if (color == colors.end()) continue;
      m_json.member(link.id.text(), color->second);
      colors.erase(color);
    }
    for (const auto& [link, color] : colors) m_json.member(link.text(), color);
    m_json.endObject();
  }

  void point(const std::pair<const LinkId, SheetPoint>& node) {
    m_json.key(node.first.text());
    place(node.second);
  }

  void place(SheetPoint at) {
    m_json.beginArray(Layout::row);
    m_json.number(at.x);
    m_json.number(at.y);
    m_json.endArray();
  }

  template <class Tag>
  void id(std::string_view name, Id<Tag> id) {
    m_json.member(name, id.text());
  }

  template <class Tag>
  void ids(std::string_view name, const std::vector<Id<Tag>>& ids) {
    m_json.key(name);
    m_json.beginArray(Layout::row);
    for (const Id<Tag> id : ids) m_json.string(id.text());
    m_json.endArray();
  }

  /// As it was written where JSON can say it: fractions, and texts like "+5", become strings.
  void value(const Number& number) {
    if (isJsonNumber(number.text())) {
      m_json.json(number.text());
    } else {
      m_json.string(number.text());
    }
  }

  void number(std::string_view name, const std::optional<Number>& number) {
    if (!number) return;
    m_json.key(name);
    value(*number);
  }

  void triple(std::string_view name, const std::optional<NumberTriple>& triple) {
    if (!triple) return;
    m_json.key(name);
    m_json.beginArray(Layout::row);
    for (const Number& number : *triple) value(number);
    m_json.endArray();
  }

  void pinned(bool isPinned) {
    if (!isPinned) return;
    m_json.key("pinned");
    m_json.json("true");
  }

  void limits(const JointLimits& limits) {
    if (!limits.any()) return;
    m_json.key("limits");
    m_json.beginArray(Layout::row);
    for (const std::optional<Number>& end : {limits.low, limits.high}) {
      if (end) {
        value(*end);
      } else {
        m_json.null();
      }
    }
    m_json.endArray();
  }

  void unknown(const UnknownMembers& members) {
    for (const auto& [name, text] : members) {
      m_json.key(name);
      m_json.json(text);
    }
  }

  JsonWriter m_json;
};

}  // namespace

std::string writeMechanism(const Mechanism& mechanism) {
  TextSink sink;
  MechanismWriter(sink).document(mechanism);  // the temporary flushes when it goes
  return sink.take();
}

template <class Element>
std::string elementJson(const Element& element) {
  TextSink sink;
  MechanismWriter(sink).object(element);  // the temporary flushes when it goes
  return sink.take();
}

template std::string elementJson(const Link&);
template std::string elementJson(const Axis&);
template std::string elementJson(const TurningJoint&);
template std::string elementJson(const GearMesh&);
template std::string elementJson(const Wheel&);
template std::string elementJson(const Coupling&);
template std::string elementJson(const ShiftState&);
template std::string elementJson(const Load&);

}  // namespace geargraph::inline document_format
