#include <algorithm>

#include "core/foundations/files/json.h"
#include "core/foundations/files/json_writer.h"
#include "core/mechanism/document_format/element_members.h"
#include "core/mechanism/document_format/file_version.h"
#include "core/mechanism/document_format/mechanism_file.h"
#include "core/mechanism/model/fields.h"

namespace geargraph {
namespace {

using Layout = JsonWriter::Layout;

/// Writes the members of a document in the order of the format.
class MechanismWriter {
 public:
  explicit MechanismWriter(ByteSink& sink) : m_json(sink) {}

  void document(const Mechanism& mechanism) {
    m_json.beginObject();
    m_json.member("format", "geargraph");
    m_json.member("version", fileVersionOf(mechanism));
    m_links = &mechanism.links;
    members(mechanism);
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
  /// The members of an object in the order of its description; one function for each type of value.
  template <class Object>
  void members(const Object& object) {
    forEachField<Object>([&](const auto& field) { member(field, object, object.*field.member); });
  }

  template <class Member, class Object, class List>
  requires DescribedList<List>
  void member(const Member& field, const Object& /*object*/, const List& elements) {
    if (elements.empty() && !field.info().isAlwaysWritten) return;
    list(field.info().name, elements, std::is_same_v<Object, Link> ? Layout::row : Layout::lines);
  }
  template <class Member, class Object, class Element>
  void member(const Member& field, const Object& /*object*/,
              const std::optional<std::vector<Element>>& elements) {
    if (elements) list(field.info().name, *elements, Layout::lines);
  }
  template <class Element>
  void list(std::string_view name, const std::vector<Element>& elements, Layout layout) {
    m_json.key(name);
    m_json.beginArray(layout);
    for (const Element& element : elements) object(element);
    m_json.endArray();
  }
  template <class Member, class Object, class Part>
  requires Described<Part>
  void member(const Member& field, const Object& /*object*/, const std::optional<Part>& part) {
    if (!part) return;
    m_json.key(field.info().name);
    object(*part);
  }
  template <class Member>
  void member(const Member& field, const Mechanism& /*mechanism*/, const View& view) {
    if (view == View{}) return;
    m_json.key(field.info().name);
    m_json.beginObject();
    members(view);
    unknown(view.unknown);
    m_json.endObject();
  }

  template <class Member, class Object, class Tag>
  void member(const Member& field, const Object& /*object*/, Id<Tag> one) {
    if (field.info().isNeeded || !one.empty()) id(field.info().name, one);
  }
  template <class Member, class Object, class Tag>
  void member(const Member& field, const Object& /*object*/, const std::optional<Id<Tag>>& one) {
    if (one) id(field.info().name, *one);
  }
  template <class Member, class Object>
  void member(const Member& field, const Object& /*object*/, const std::vector<ShiftElementId>& all) {
    if (field.info().isNeeded || !all.empty()) ids(field.info().name, all);
  }
  template <class Member, class Object>
  void member(const Member& field, const Object& /*object*/, const std::string& text) {
    const MemberInfo& info = field.info();
    if (info.isNeeded || info.isAlwaysWritten || !text.empty()) m_json.member(info.name, text);
  }
  template <class Member, class Object>
  void member(const Member& field, const Object& /*object*/, bool flag) {
    if (!flag) return;
    m_json.key(field.info().name);
    m_json.json("true");
  }
  template <class Member, class Object>
  void member(const Member& field, const Object& object, int teeth) {
    if constexpr (std::is_same_v<Object, GearMesh>) {
      if (!statesTeeth(object)) return;
    }
    m_json.member(field.info().name, teeth);
  }
  template <class Member, class Object>
  void member(const Member& field, const Object& /*object*/, const Number& one) {
    number(field.info().name, one);
  }
  template <class Member, class Object>
  void member(const Member& field, const Object& /*object*/, const std::optional<Number>& one) {
    number(field.info().name, one);
  }
  template <class Member, class Object>
  void member(const Member& field, const Object& /*object*/, const std::optional<NumberTriple>& three) {
    triple(field.info().name, three);
  }
  template <class Member, class Object>
  void member(const Member& field, const Object& /*object*/, const std::optional<MeshKind>& kind) {
    if (kind) m_json.member(field.info().name, meshKindName(*kind));
  }
  template <class Member, class Object>
  void member(const Member& field, const Object& /*object*/, JointKind kind) {
    if (kind != JointKind::turning) m_json.member(field.info().name, jointKindName(kind));
  }
  template <class Member, class Object>
  void member(const Member& field, const Object& /*object*/, const std::optional<Hand>& hand) {
    if (hand) m_json.member(field.info().name, handName(*hand));
  }
  template <class Member, class Object>
  void member(const Member& field, const Object& /*object*/, const std::optional<LoadSharing>& sharing) {
    if (sharing) m_json.member(field.info().name, loadSharingName(*sharing));
  }

  template <class Member, class Object>
  void member(const Member& field, const Object& /*object*/, const SharedOptional<LinkMass>& mass) {
    if (!mass) return;
    number(field.infos[kMass].name, mass->mass);
    triple(field.infos[kCenterOfMass].name, mass->center);
    if (!mass->inertia) return;
    m_json.key(field.infos[kInertia].name);
    m_json.beginArray(Layout::row);
    for (const Number& number : *mass->inertia) value(number);
    m_json.endArray();
  }
  template <class Member, class Object>
  void member(const Member& field, const Object& /*object*/, const JointLimits& limits) {
    if (!limits.any()) return;
    m_json.key(field.info().name);
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
  template <class Member>
  void member(const Member& field, const ShiftElement& coupling, const std::vector<LinkId>& links) {
    const bool isBrake = coupling.kind == ShiftElementKind::brake;
    m_json.member(field.infos[kCouplingKind].name, couplingKindName(coupling.kind));
    if (isBrake) {
      id(field.infos[kBrakeLink].name, links.front());
    } else {
      ids(field.infos[kClutchLinks].name, links);
    }
  }
  template <class Member>
  void member(const Member& field, const Load& /*load*/, const decltype(Load::action)& action) {
    const auto& [jointInfo, linkInfo, axisInfo, torqueInfo, forceInfo, pointInfo] = field.infos;
    if (const auto* inJoint = std::get_if<JointTorque>(&action)) {
      id(jointInfo.name, inJoint->joint);
      number(torqueInfo.name, inJoint->torque);
    } else if (const auto* torque = std::get_if<LinkTorque>(&action)) {
      id(linkInfo.name, torque->link);
      if (torque->axis) id(axisInfo.name, *torque->axis);
      number(torqueInfo.name, torque->torque);
    } else {
      const auto& force = std::get<LinkForce>(action);
      id(linkInfo.name, force.link);
      triple(forceInfo.name, force.force);
      triple(pointInfo.name, force.point);
    }
  }
  template <class Member>
  void member(const Member& field, const HoldingTorque& /*balance*/, const decltype(HoldingTorque::at)& at) {
    const auto& [jointInfo, linkInfo, axisInfo] = field.infos;
    if (const auto* joint = std::get_if<JointId>(&at)) {
      id(jointInfo.name, *joint);
      return;
    }
    const auto& onLink = std::get<HoldingTorque::OnLink>(at);
    id(linkInfo.name, onLink.link);
    if (onLink.axis) id(axisInfo.name, *onLink.axis);
  }

  template <class Member, class Object>
  void member(const Member& field, const Object& /*object*/, const CanvasPoint& at) {
    m_json.key(field.info().name);
    place(at);
  }
  template <class Member, class Object>
  void member(const Member& field, const Object& /*object*/, const std::array<double, 3>& position) {
    m_json.key(field.info().name);
    m_json.beginArray(Layout::row);
    for (const double coordinate : position) m_json.number(coordinate);
    m_json.endArray();
  }
  template <class Member, class Object>
  void member(const Member& field, const Object& /*object*/, double measure) {
    m_json.member(field.info().name, measure);
  }

  /// Nodes in the order of the links, so that a saved file reads like its list of links.
  template <class Member>
  void member(const Member& field, const View& /*view*/, std::map<LinkId, CanvasPoint> nodes) {
    if (nodes.empty()) return;
    m_json.key(field.info().name);
    m_json.beginObject();
    for (const Link& link : *m_links) {
      const auto node = nodes.find(link.id);
      if (node == nodes.end()) continue;
      point(*node);
      nodes.erase(node);
    }
    for (const auto& node : nodes) point(node);
    m_json.endObject();
  }

  template <class Member>
  void member(const Member& field, const View& /*view*/, std::map<LinkId, int> numbers) {
    if (numbers.empty()) return;
    m_json.key(field.info().name);
    m_json.beginObject(Layout::row);
    for (const Link& link : *m_links) {
      const auto number = numbers.find(link.id);
      if (number == numbers.end()) continue;
      m_json.member(link.id.text(), number->second);
      numbers.erase(number);
    }
    for (const auto& [link, number] : numbers) m_json.member(link.text(), number);
    m_json.endObject();
  }

  void point(const std::pair<const LinkId, CanvasPoint>& node) {
    m_json.key(node.first.text());
    place(node.second);
  }

  void place(CanvasPoint at) {
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

  void unknown(const UnknownMembers& members) {
    for (const auto& [name, text] : members) {
      m_json.key(name);
      m_json.json(text);
    }
  }

  JsonWriter m_json;
  const std::vector<Link>* m_links = nullptr;  ///< of the document
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
template std::string elementJson(const ShiftElement&);
template std::string elementJson(const ShiftState&);
template std::string elementJson(const Load&);

}  // namespace geargraph
