#include "core/mechanism/document_format/element_reader.h"

#include <algorithm>
#include <cmath>

#include "core/foundations/base/text_lists.h"
#include "core/foundations/base/translation.h"
#include "core/mechanism/model/fields.h"

namespace geargraph {
namespace {

std::optional<MeshKind> meshKindOf(JsonObject& from, std::string_view name) {
  const auto value = from.member(name);
  if (!value) return std::nullopt;
  for (const MeshKind kind : meshKinds()) {
    if (value->is(JsonKind::string) && value->equals(meshKindName(kind))) return kind;
  }
  std::vector<std::string> names;
  for (const MeshKind kind : meshKinds()) names.push_back('"' + std::string(meshKindName(kind)) + '"');
  from.wrong(name, *value, listed(names, kAllNames, "or"));
  return std::nullopt;
}

std::optional<Hand> handOf(JsonObject& from, std::string_view name) {
  const auto value = from.member(name);
  if (!value) return std::nullopt;
  const auto hand = value->is(JsonKind::string) ? handFrom(value->string()) : std::nullopt;
  if (!hand) from.wrong(name, *value, toTranslate("\"right\" or \"left\""));
  return hand;
}

std::optional<AxisId> optionalAxis(JsonObject& from, std::string_view name) {
  const auto axis = from.id(name);
  return axis ? std::optional(AxisId(*axis)) : std::nullopt;
}

/// Reads the fields of one object in the order of its description; one function for each type of value.
template <class Element>
class FieldReader {
 public:
  FieldReader(JsonObject& from, Element& element) : m_from(from), m_element(element) {}

  template <class Member>
  void operator()(const Member& field) const {
    read(field, m_element.*field.member);
  }

 private:
  template <class Member, class Tag>
  void read(const Member& field, Id<Tag>& id) const {
    const MemberInfo& info = field.info();
    if (info.value == MemberValue::id) return;  // read before
    id = Id<Tag>(m_from.requiredId(info.name));
    if (info.namesElement && !id.empty()) m_from.blame(id);
  }
  template <class Member, class Tag>
  void read(const Member& field, std::optional<Id<Tag>>& id) const {
    if (const auto given = m_from.id(field.info().name)) id = Id<Tag>(*given);
  }
  template <class Member>
  void read(const Member& field, bool& flag) const {
    flag = m_from.flag(field.info().name).value_or(false);
  }
  template <class Member>
  void read(const Member& field, int& teeth) const {
    if (leavesTeethOut() && !m_from.member(field.info().name)) {
      teeth = kMinTeeth;  // settleWeights() sets it
      return;
    }
    teeth = m_from.requiredWhole(field.info().name, kMinTeeth, kMaxTeeth);
  }
  /// Pins, and belts with running diameters.
  [[nodiscard]] bool leavesTeethOut() const {
    const auto kind = m_from.member("kind");
    const bool isToothless =
        kind && std::any_of(meshKinds().begin(), meshKinds().end(), [&](MeshKind each) {
          return !pairKind(each).hasTeeth && kind->is(JsonKind::string) && kind->equals(meshKindName(each));
        });
    return isToothless || m_from.member("tailDiameter") || m_from.member("headDiameter");
  }
  template <class Member>
  void read(const Member& field, Number& number) const {
    const MemberInfo& info = field.info();
    if (info.isNeeded) (void)m_from.required(info.name, info.expected);
    number = m_from.number(info.name).value_or(Number());
  }
  template <class Member>
  void read(const Member& field, JointLimits& limits) const {
    if (const auto ends = m_from.ends(field.info().name)) limits = {(*ends)[0], (*ends)[1]};
  }
  template <class Member>
  void read(const Member& field, std::optional<MeshKind>& kind) const {
    kind = meshKindOf(m_from, field.info().name);
  }
  template <class Member>
  void read(const Member& field, JointKind& kind) const {
    const auto value = m_from.member(field.info().name);
    if (!value) return;
    const auto named = value->is(JsonKind::string) ? jointKindFrom(value->string()) : std::nullopt;
    if (named) {
      kind = *named;
    } else {
      m_from.wrong(field.info().name, *value, toTranslate("\"turning\" or \"sliding\""));
    }
  }
  template <class Member>
  void read(const Member& field, std::optional<Hand>& hand) const {
    hand = handOf(m_from, field.info().name);
  }
  template <class Member>
  void read(const Member& field, SharedOptional<LinkMass>& stated) const {
    const auto& [massInfo, centerInfo, inertiaInfo] = field.infos;
    const auto mass = m_from.number(massInfo.name);
    const auto center = m_from.triple(centerInfo.name);
    const auto inertia = m_from.inertia(inertiaInfo.name);
    if (mass) stated = LinkMass{*mass, center, inertia};
    if (m_from.member(massInfo.name)) return;
    for (const std::string_view name : {centerInfo.name, inertiaInfo.name}) {
      if (const auto value = m_from.member(name)) m_from.wrong(name, *value, massInfo.expected);
    }
  }
  template <class Member>
  void read(const Member& field, std::vector<LinkShape>& shapes) const {
    const MemberInfo& info = field.info();
    const auto list = m_from.member(info.name);
    const std::string pointer = m_from.pointer() + pointerStep(info.name);
    if (!list || m_from.diagnostics().covers(pointer)) return;
    if (!list->is(JsonKind::array)) return m_from.wrong(info.name, *list, info.expected);
    list->forEachElement([&](JsonValue value, std::size_t position) {
      JsonObject from(m_from.diagnostics(), value, pointer + pointerStep(position));
      from.blame(m_element.id);
      LinkShape& shape = shapes.emplace_back();
      readMembers(from, shape);
      shape.unknown = from.unknown();
    });
  }

  /// Kind and links of a coupling.
  template <class Member>
  void read(const Member& field, std::vector<LinkId>& links) const {
    const MemberInfo& kindInfo = field.infos[kCouplingKind];
    const MemberInfo& listInfo = field.infos[kClutchLinks];
    const auto kind = m_from.required(kindInfo.name, kindInfo.expected);
    const auto is = [&](std::string_view name) {
      return kind && kind->is(JsonKind::string) && kind->equals(name);
    };
    if (is("brake")) {
      m_element.kind = ShiftElementKind::brake;
      links = {LinkId(m_from.requiredId(field.infos[kBrakeLink].name))};
    } else if (is("clutch") || is("freewheel")) {
      m_element.kind = is("clutch") ? ShiftElementKind::clutch : ShiftElementKind::freewheel;
      (void)m_from.required(listInfo.name, listInfo.expected);
      for (const InternedString id : m_from.ids(listInfo.name).value_or(std::vector<InternedString>{}))
        links.emplace_back(id);
    } else if (kind) {
      m_from.wrong(kindInfo.name, *kind, kindInfo.expected);
    }
  }

  template <class Member>
  void read(const Member& field, decltype(Load::action)& action) const {
    const auto& [jointInfo, linkInfo, axisInfo, torqueInfo, forceInfo, pointInfo] = field.infos;
    const auto requiredTorque = [&, &info = torqueInfo] {
      (void)m_from.required(info.name, info.expected);
      return m_from.number(info.name).value_or(Number());
    };
    const auto link = oneOfJointAndLink(jointInfo, linkInfo);
    if (!link) {
      const JointId joint(m_from.requiredId(jointInfo.name));
      action = JointTorque{joint, requiredTorque()};
      return;
    }
    const auto force = m_from.member(forceInfo.name);
    if (!force) {
      const std::optional<AxisId> axis = optionalAxis(m_from, axisInfo.name);
      action = LinkTorque{*link, axis, requiredTorque()};
      return;
    }
    if (const auto both = m_from.member(torqueInfo.name))
      m_from.wrong(torqueInfo.name, *both, toTranslate("a torque or a force, not both in one load"));
    (void)m_from.required(pointInfo.name, pointInfo.expected);
    LinkForce onLink{*link, {}, {}};
    if (const auto components = m_from.triple(forceInfo.name)) onLink.force = *components;
    if (const auto point = m_from.triple(pointInfo.name)) onLink.point = *point;
    action = onLink;
  }
  template <class Member>
  void read(const Member& field, decltype(HoldingTorque::at)& at) const {
    const auto& [jointInfo, linkInfo, axisInfo] = field.infos;
    if (const auto link = oneOfJointAndLink(jointInfo, linkInfo)) {
      at = HoldingTorque::OnLink{*link, optionalAxis(m_from, axisInfo.name)};
    } else {
      at = JointId(m_from.requiredId(jointInfo.name));
    }
  }

  /// The link where the object names one; else it has to name a joint.
  std::optional<LinkId> oneOfJointAndLink(const MemberInfo& jointInfo, const MemberInfo& linkInfo) const {
    const auto link = m_from.member(linkInfo.name);
    if (!link) return std::nullopt;
    if (m_from.member(jointInfo.name))
      m_from.wrong(linkInfo.name, *link, toTranslate("a joint or a link, not both"));
    return LinkId(m_from.requiredId(linkInfo.name));
  }

  template <class Member>
  void read(const Member& field, CanvasPoint& place) const {
    const MemberInfo& info = field.info();
    const auto at = m_from.required(info.name, info.expected);
    if (!at) return;
    const auto point = coordinatesOf<2>(*at);
    if (!point) m_from.wrong(info.name, *at, toTranslate("a list of two numbers, x to the right and y down"));
    // Without the sign of a zero, as edits leave it.
    if (point) place = {(*point)[0] + 0.0, (*point)[1] + 0.0};
  }
  template <class Member>
  void read(const Member& field, std::array<double, 3>& position) const {
    const MemberInfo& info = field.info();
    const auto value = m_from.required(info.name, info.expected);
    if (!value) return;
    const auto point = coordinatesOf<3>(*value);
    if (!point) m_from.wrong(info.name, *value, toTranslate("a list of three numbers"));
    position = point.value_or(position);
  }
  template <class Member>
  void read(const Member& field, double& measure) const {
    const MemberInfo& info = field.info();
    const auto member = m_from.required(info.name, info.expected);
    const auto read = member ? finiteNumber(*member) : std::nullopt;
    if (member && !read) m_from.wrong(info.name, *member, info.expected);
    measure = read.value_or(measure);
  }

  /// Values that the document has, too.
  template <class Member, class Value>
  requires requires(JsonObject& from, const MemberInfo& info, Value& value) { readValue(from, info, value); }
  void read(const Member& field, Value& value) const { readValue(m_from, field.info(), value); }

  JsonObject& m_from;
  Element& m_element;
};

}  // namespace

std::optional<double> finiteNumber(JsonValue value) {
  const auto number = value.is(JsonKind::number) ? Number::fromText(value.slice()) : std::nullopt;
  if (!number || !std::isfinite(number->value())) return std::nullopt;
  return number->value();
}

template <std::size_t count>
std::optional<std::array<double, count>> coordinatesOf(JsonValue value) {
  if (!value.is(JsonKind::array) || value.size() != count) return std::nullopt;
  std::array<double, count> coordinates{};
  bool complete = true;
  value.forEachElement([&](JsonValue element, std::size_t i) {
    const auto number = finiteNumber(element);
    complete = complete && number.has_value();
    coordinates[i] = number.value_or(0);
  });
  return complete ? std::optional(coordinates) : std::nullopt;
}
template std::optional<std::array<double, 2>> coordinatesOf(JsonValue value);

void readValue(JsonObject& from, const MemberInfo& info, std::string& value) {
  if (info.isNeeded) (void)from.required(info.name, info.expected);
  auto given = info.value == MemberValue::shortText ? from.shortText(info.name) : from.text(info.name);
  if (given) value = *std::move(given);
}

void readValue(JsonObject& from, const MemberInfo& info, std::optional<Number>& value) {
  value = from.number(info.name);
}

void readValue(JsonObject& from, const MemberInfo& info, std::optional<NumberTriple>& value) {
  value = from.triple(info.name);
}

void readValue(JsonObject& from, const MemberInfo& info, std::optional<LoadSharing>& value) {
  const auto member = from.member(info.name);
  if (!member) return;
  if (member->is(JsonKind::string)) value = loadSharingFrom(member->string());
  if (!value) from.wrong(info.name, *member, toTranslate("\"none\" or \"stiffness\""));
}

void readValue(JsonObject& from, const MemberInfo& info, std::vector<ShiftElementId>& value) {
  if (info.isNeeded) (void)from.required(info.name, info.expected);
  for (const InternedString id : from.ids(info.name).value_or(std::vector<InternedString>{}))
    value.emplace_back(id);
}

template <class Element>
void readMembers(JsonObject& from, Element& element) {
  forEachField<Element>(FieldReader<Element>(from, element));
  if constexpr (std::is_same_v<Element, GearMesh>) {
    // Teeth that contradict them stay, for wellFormedDiagnostics() to say so.
    const bool statesSome = from.member("tailTeeth") || from.member("headTeeth");
    const std::int64_t tail = element.tailTeeth, head = element.headTeeth;
    settleWeights(element);
    if (statesSome && tail * element.headTeeth != head * element.tailTeeth) {
      element.tailTeeth = static_cast<int>(tail);
      element.headTeeth = static_cast<int>(head);
    }
  }
}

template void readMembers(JsonObject& from, Link& link);
template void readMembers(JsonObject& from, Axis& axis);
template void readMembers(JsonObject& from, TurningJoint& joint);
template void readMembers(JsonObject& from, GearMesh& mesh);
template void readMembers(JsonObject& from, Wheel& wheel);
template void readMembers(JsonObject& from, GearDefaults& defaults);
template void readMembers(JsonObject& from, Input& input);
template void readMembers(JsonObject& from, ShiftElement& coupling);
template void readMembers(JsonObject& from, ShiftState& state);
template void readMembers(JsonObject& from, Load& load);
template void readMembers(JsonObject& from, HoldingTorque& balance);
template void readMembers(JsonObject& from, CanvasNote& note);
template void readMembers(JsonObject& from, ViewCamera& camera);

}  // namespace geargraph
