#include "core/mechanism/model/unknown_members.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "core/foundations/base/nearest_name.h"
#include "core/foundations/base/translation.h"
#include "core/mechanism/model/fields.h"

namespace geargraph {
namespace {

// clang-format off
/// Names that no other program is likely to mean, and the members that are meant.
constexpr auto kMisspellings = std::to_array<std::pair<std::string_view, std::string_view>>({
    {"axises", "axes"}, {"balance", "balances"}, {"centerofmass", "centerOfMass"},
    {"center_of_mass", "centerOfMass"}, {"centreOfMass", "centerOfMass"}, {"coupling", "couplings"},
    {"densitiy", "density"}, {"effciency", "efficiency"}, {"efficency", "efficiency"},
    {"efficiancy", "efficiency"}, {"efficieny", "efficiency"}, {"effiency", "efficiency"},
    {"eficiency", "efficiency"}, {"face_width", "faceWidth"}, {"facewidth", "faceWidth"},
    {"fricton", "friction"}, {"gearDefault", "gearDefaults"}, {"gearMesh", "gearMeshes"},
    {"gear_meshes", "gearMeshes"}, {"gearmeshes", "gearMeshes"}, {"headwheel", "headWheel"},
    {"input", "inputs"}, {"joints", "turningJoints"}, {"limit", "limits"}, {"load", "loads"},
    {"meshes", "gearMeshes"}, {"pitch_point", "pitchPoint"}, {"pitchpoint", "pitchPoint"},
    {"pressure_angle", "pressureAngle"}, {"pressureangle", "pressureAngle"},
    {"profile_shift", "profileShift"}, {"profileshift", "profileShift"}, {"shape", "shapes"},
    {"state", "states"}, {"tailwheel", "tailWheel"}, {"turningJoint", "turningJoints"},
    {"turning_joints", "turningJoints"}, {"turningjoints", "turningJoints"},
    {"units", "unit"}, {"wheel", "wheels"}});
// clang-format on

/// Collects the unknown members of a mechanism by part and name.
class UnknownMemberList {
 public:
  Diagnostics run(const Mechanism& mechanism) {
    object(mechanism, {});
    return diagnostics();
  }

 private:
  using Element = std::optional<ElementId>;

  /// What diagnostics about the object name; for an object without a name, those about the one around it.
  template <class Object>
  static Element elementOf(const Object& object, const Element& around) {
    if constexpr (requires { object.id; }) {
      return object.id.empty() ? std::nullopt : Element(ElementId(object.id));
    } else if constexpr (std::is_same_v<Object, Input>) {
      return ElementId(object.joint);
    } else if constexpr (std::is_same_v<Object, ShiftState>) {
      return ElementId(ElementKind::state, InternedString(object.name));
    } else if constexpr (std::is_same_v<Object, HoldingTorque>) {
      const auto* const joint = std::get_if<JointId>(&object.at);
      return joint != nullptr ? ElementId(*joint)
                              : ElementId(std::get<HoldingTorque::OnLink>(object.at).link);
    } else {
      return around;
    }
  }

  template <class Object>
  void object(const Object& object, const Element& around) {
    const Element element = elementOf(object, around);
    add(Description<Object>::part, object.unknown, element);
    forEachField<Object>([&](const auto& field) { inside(object.*field.member, element); });
  }

  template <class Value>
  void inside(const Value& value, const Element& around) {
    if constexpr (Described<Value>) {
      object(value, around);
    } else if constexpr (DescribedList<Value>) {
      for (const auto& each : value) object(each, around);
    }
  }
  template <class Value>
  void inside(const std::optional<Value>& value, const Element& around) {
    if (value) inside(*value, around);
  }

  void add(DocumentPart part, const UnknownMembers& members, const Element& element) {
    for (const auto& [name, value] : members) {
      std::vector<ElementId>& elements = m_found[{part, name}];
      if (element && (elements.empty() || elements.back() != *element)) elements.push_back(*element);
    }
  }

  [[nodiscard]] Diagnostics diagnostics() const {
    Diagnostics all;
    for (const auto& [key, elements] : m_found) {
      all.push_back({Code::unknownMember, sentence(key.second, key.first), elements, {}});
    }
    return all;
  }

  static std::string sentence(const std::string& name, DocumentPart part) {
    const std::string_view list = partName(part);
    if (memberOf(part, name) != nullptr) {
      return translated(
          "The member \"%1\" in %2 has no meaning beside the others of its object: it is kept and changes "
          "nothing.",
          {name, list});
    }
    const std::string notKnown =
        list.empty()
            ? translated(
                  "The member \"%1\" of the document is not known here: it is kept and changes nothing.",
                  {name})
            : translated("The member \"%1\" in %2 is not known here: it is kept and changes nothing.",
                         {name, list});
    const auto nearest = nearestName(name, memberNames(part));
    return nearest ? notKnown + ' ' + translated("Is \"%1\" meant?", {*nearest}) : notKnown;
  }

  std::map<std::pair<DocumentPart, std::string>, std::vector<ElementId>> m_found;
};

}  // namespace

Diagnostics unknownMemberDiagnostics(const Mechanism& mechanism) {
  return UnknownMemberList().run(mechanism);
}

std::string_view misspelledMember(std::string_view name) {
  const auto found = std::find_if(kMisspellings.begin(), kMisspellings.end(),
                                  [&](const auto& entry) { return entry.first == name; });
  return found == kMisspellings.end() ? std::string_view() : found->second;
}

}  // namespace geargraph
