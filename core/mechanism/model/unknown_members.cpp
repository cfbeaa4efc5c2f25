#include "core/mechanism/model/unknown_members.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "core/foundations/base/contract.h"
#include "core/foundations/base/nearest_name.h"
#include "core/foundations/base/words.h"

namespace geargraph::inline model {
namespace {

using Names = std::span<const std::string_view>;

// clang-format off
constexpr auto kDocumentNames = std::to_array<std::string_view>({
    "format", "version", "name", "notes", "unit", "links", "axes", "turningJoints", "gearMeshes", "wheels",
    "gearDefaults", "inputs", "couplings", "states", "engaged", "loads", "balances", "sharing", "driveTorque", "density",
    "gravity", "view"});
constexpr auto kLinkNames = std::to_array<std::string_view>({
    "id", "name", "pinned", "mass", "centerOfMass", "inertia", "shapes"});
constexpr auto kShapeNames = std::to_array<std::string_view>({"file", "position", "orientation", "scale"});
constexpr auto kAxisNames = std::to_array<std::string_view>({"id", "point", "direction", "pinned"});
constexpr auto kJointNames = std::to_array<std::string_view>({"id", "tail", "head", "axis", "offset", "limits"});
constexpr auto kMeshNames = std::to_array<std::string_view>({
    "id", "tail", "head", "tailTeeth", "headTeeth", "pitchPoint", "kind", "faceWidth", "tailWheel", "headWheel",
    "pinned", "efficiency", "friction"});
constexpr auto kWheelNames = std::to_array<std::string_view>({"id", "link", "profileShift", "bore", "backlash"});
constexpr auto kDefaultNames = std::to_array<std::string_view>({
    "pressureAngle", "backlash", "faceWidth", "efficiency", "friction"});
constexpr auto kInputNames = std::to_array<std::string_view>({"joint", "speed"});
constexpr auto kCouplingNames = std::to_array<std::string_view>({"id", "kind", "link", "links"});
constexpr auto kStateNames = std::to_array<std::string_view>({"name", "engaged", "drive", "driven"});
constexpr auto kLoadNames = std::to_array<std::string_view>({
    "id", "joint", "link", "axis", "torque", "force", "point"});
constexpr auto kBalanceNames = std::to_array<std::string_view>({"joint", "link", "axis"});
constexpr auto kViewNames = std::to_array<std::string_view>({"nodes", "ttNodes", "notes", "camera", "colors"});
constexpr auto kNoteNames = std::to_array<std::string_view>({"id", "text", "at"});
constexpr auto kCameraNames = std::to_array<std::string_view>({"target", "azimuth", "elevation", "distance"});

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

struct PartEntry {
  DocumentPart part;
  std::string_view name;
  Names members;
};

// In the order of the enumeration.
constexpr std::array kParts = {
    PartEntry{DocumentPart::document, "", kDocumentNames},
    PartEntry{DocumentPart::link, "links", kLinkNames},
    PartEntry{DocumentPart::shape, "links/shapes", kShapeNames},
    PartEntry{DocumentPart::axis, "axes", kAxisNames},
    PartEntry{DocumentPart::turningJoint, "turningJoints", kJointNames},
    PartEntry{DocumentPart::gearMesh, "gearMeshes", kMeshNames},
    PartEntry{DocumentPart::wheel, "wheels", kWheelNames},
    PartEntry{DocumentPart::gearDefaults, "gearDefaults", kDefaultNames},
    PartEntry{DocumentPart::input, "inputs", kInputNames},
    PartEntry{DocumentPart::coupling, "couplings", kCouplingNames},
    PartEntry{DocumentPart::state, "states", kStateNames},
    PartEntry{DocumentPart::load, "loads", kLoadNames},
    PartEntry{DocumentPart::balance, "balances", kBalanceNames},
    PartEntry{DocumentPart::view, "view", kViewNames},
    PartEntry{DocumentPart::note, "view/notes", kNoteNames},
    PartEntry{DocumentPart::camera, "view/camera", kCameraNames},
};

const PartEntry& entryOf(DocumentPart part) {
  const PartEntry& entry = kParts.at(static_cast<std::size_t>(part));
  GEARGRAPH_REQUIRE(entry.part == part);
  return entry;
}

/// Collects the unknown members of a mechanism by part and name.
class UnknownMemberList {
 public:
  Diagnostics run(const Mechanism& mechanism) {
    for (const Link& link : mechanism.links) {
      add(DocumentPart::link, link.unknown, link.id);
      for (const LinkShape& shape : link.shapes) add(DocumentPart::shape, shape.unknown, link.id);
    }
    for (const Axis& axis : mechanism.axes) add(DocumentPart::axis, axis.unknown, axis.id);
    for (const TurningJoint& joint : mechanism.turningJoints)
      add(DocumentPart::turningJoint, joint.unknown, joint.id);
    for (const GearMesh& mesh : mechanism.gearMeshes) add(DocumentPart::gearMesh, mesh.unknown, mesh.id);
    for (const Wheel& wheel : mechanism.wheels) add(DocumentPart::wheel, wheel.unknown, wheel.id);
    if (mechanism.gearDefaults) add(DocumentPart::gearDefaults, mechanism.gearDefaults->unknown, {});
    if (mechanism.inputs) {
      for (const Input& input : *mechanism.inputs) add(DocumentPart::input, input.unknown, input.joint);
    }
    for (const Coupling& coupling : mechanism.couplings)
      add(DocumentPart::coupling, coupling.unknown, coupling.id);
    for (const ShiftState& state : mechanism.states)
      add(DocumentPart::state, state.unknown, ElementId(ElementKind::state, Atom(state.name)));
    for (const Load& load : mechanism.loads) add(DocumentPart::load, load.unknown, loadElement(load));
    if (mechanism.balances) {
      for (const Balance& balance : *mechanism.balances)
        add(DocumentPart::balance, balance.unknown, balanceElement(balance));
    }
    add(DocumentPart::document, mechanism.unknown, {});
    view(mechanism.view);
    return diagnostics();
  }

 private:
  using Element = std::optional<ElementId>;

  static Element loadElement(const Load& load) {
    return load.id.empty() ? std::nullopt : Element(ElementId(load.id));
  }

  static Element balanceElement(const Balance& balance) {
    const auto* const joint = std::get_if<JointId>(&balance.at);
    return joint != nullptr ? ElementId(*joint) : ElementId(std::get<Balance::OnLink>(balance.at).link);
  }

  void view(const View& view) {
    add(DocumentPart::view, view.unknown, {});
    for (const SheetNote& note : view.notes) add(DocumentPart::note, note.unknown, note.id);
    if (view.camera) add(DocumentPart::camera, view.camera->unknown, {});
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
      all.push_back({Code::unknownMember, sentence(key.second, entryOf(key.first)), elements, {}});
    }
    return all;
  }

  static std::string sentence(const std::string& name, const PartEntry& part) {
    if (std::find(part.members.begin(), part.members.end(), name) != part.members.end()) {
      return translated(
          "The member \"%1\" in %2 has no meaning beside the others of its object: it is kept and changes "
          "nothing.",
          {name, part.name});
    }
    const std::string notKnown =
        part.name.empty()
            ? translated(
                  "The member \"%1\" of the document is not known here: it is kept and changes nothing.",
                  {name})
            : translated("The member \"%1\" in %2 is not known here: it is kept and changes nothing.",
                         {name, part.name});
    const auto nearest = nearestName(name, part.members);
    return nearest ? notKnown + ' ' + translated("Is \"%1\" meant?", {*nearest}) : notKnown;
  }

  std::map<std::pair<DocumentPart, std::string>, std::vector<ElementId>> m_found;
};

}  // namespace

std::span<const std::string_view> memberNames(DocumentPart part) {
  return entryOf(part).members;
}

std::string_view partName(DocumentPart part) {
  return entryOf(part).name;
}

Diagnostics unknownMemberDiagnostics(const Mechanism& mechanism) {
  return UnknownMemberList().run(mechanism);
}

std::string_view misspelledMember(std::string_view name) {
  const auto found = std::find_if(kMisspellings.begin(), kMisspellings.end(),
                                  [&](const auto& entry) { return entry.first == name; });
  return found == kMisspellings.end() ? std::string_view() : found->second;
}

}  // namespace geargraph::inline model
