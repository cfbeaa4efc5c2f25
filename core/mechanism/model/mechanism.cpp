#include "core/mechanism/model/mechanism.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <numbers>
#include <set>
#include <string>
#include <tuple>

#include "core/foundations/base/contract.h"
#include "core/foundations/base/translation.h"

namespace geargraph {
namespace {

template <class Element, class ElementIdType>
const Element* findIn(const std::vector<Element>& list, ElementIdType id) {
  const auto found = std::find_if(list.begin(), list.end(), [id](const Element& e) { return e.id == id; });
  return found == list.end() ? nullptr : &*found;
}

template <class Element>
std::optional<int> positionIn(const std::vector<Element>& list, InternedString id) {
  const auto found =
      std::find_if(list.begin(), list.end(), [id](const Element& e) { return e.id.atom() == id; });
  if (found == list.end()) return std::nullopt;
  return static_cast<int>(found - list.begin());
}

/// A positive fraction as two whole numbers in lowest terms, from kMinTeeth to kMaxTeeth.
std::optional<std::pair<int, int>> wholeRatio(const Rational& ratio) {
  const std::string text = ratio.toString();  // "57/20"
  const std::size_t bar = text.find('/');
  const auto whole = [](std::string_view digits) -> std::optional<int> {
    int value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error != std::errc() || value < kMinTeeth || value > kMaxTeeth) return std::nullopt;
    return value;
  };
  const auto a = whole(std::string_view(text).substr(0, bar));
  const auto b = bar == std::string::npos ? 1 : whole(std::string_view(text).substr(bar + 1));
  if (!a || !b) return std::nullopt;
  return std::pair(*a, *b);
}

}  // namespace

double helixOf(const GearMesh& mesh) {
  if (!mesh.helixAngle) return 0;
  return signOf(mesh.hand.value_or(Hand::right)) * mesh.helixAngle->value() * std::numbers::pi / 180;
}

bool statesTeeth(const GearMesh& mesh) {
  return pairKind(saidKind(mesh)).hasTeeth && !mesh.tailDiameter && !mesh.headDiameter;
}

std::optional<std::pair<int, int>> weightsWithoutTeeth(const GearMesh& mesh) {
  GEARGRAPH_REQUIRE(!statesTeeth(mesh));
  if (!pairKind(saidKind(mesh)).hasTeeth) return std::pair(1, 1);
  if (!mesh.tailDiameter || !mesh.headDiameter) return std::nullopt;
  const Rational tail = mesh.tailDiameter->exact();
  const Rational head = mesh.headDiameter->exact();
  if (tail.sign() <= 0 || head.sign() <= 0) return std::nullopt;
  return wholeRatio(tail / head);
}

std::optional<MeshWeights> weightsOf(const GearMesh& mesh, bool tailSlides) {
  const PairKind& kind = pairKind(saidKind(mesh));
  if (!kind.slides) return MeshWeights{mesh.tailTeeth, mesh.headTeeth};
  const std::optional<Number>& length = !kind.hasTeeth ? mesh.lead : mesh.module ? mesh.module : mesh.pitch;
  if (!length || length->exact().sign() <= 0) return std::nullopt;
  const int teeth = !kind.hasTeeth ? 1 : tailSlides ? mesh.headTeeth : mesh.tailTeeth;
  const auto whole = wholeRatio(Rational(teeth, 2) * length->exact());
  if (!whole) return std::nullopt;
  const bool byModule = kind.hasTeeth && mesh.module;
  const int power = byModule ? 0 : 1;  // a : b = X / pi : 1
  if (tailSlides) return MeshWeights{whole->second, whole->first, -power};
  return MeshWeights{whole->first, whole->second, power};
}

bool hasSlides(const Mechanism& mechanism) {
  return std::any_of(mechanism.turningJoints.begin(), mechanism.turningJoints.end(),
                     [](const TurningJoint& joint) { return slides(joint); });
}

void settleWeights(GearMesh& mesh) {
  if (statesTeeth(mesh)) return;
  if (const auto weights = weightsWithoutTeeth(mesh)) std::tie(mesh.tailTeeth, mesh.headTeeth) = *weights;
}

bool tailSlides(const Mechanism& mechanism, const GearMesh& mesh) {
  std::map<LinkId, std::vector<const TurningJoint*>> joints;
  for (const TurningJoint& joint : mechanism.turningJoints) {
    joints[joint.tail].push_back(&joint);
    joints[joint.head].push_back(&joint);
  }
  std::set<LinkId> reached{mesh.head};
  std::vector<LinkId> queue{mesh.head};
  for (std::size_t next = 0; next < queue.size(); ++next) {
    const LinkId link = queue[next];
    for (const TurningJoint* const joint : joints[link]) {
      const LinkId other = joint->tail == link ? joint->head : joint->tail;
      if (other == mesh.tail) return slides(*joint);
      if (reached.insert(other).second) queue.push_back(other);
    }
  }
  return false;
}

std::string_view couplingKindName(ShiftElementKind kind) {
  switch (kind) {
    case ShiftElementKind::brake:
      return "brake";
    case ShiftElementKind::clutch:
      return "clutch";
    case ShiftElementKind::freewheel:
      return "freewheel";
  }
  GEARGRAPH_REQUIRE(false);
}

std::string couplingName(ShiftElementKind kind, std::string_view id) {
  switch (kind) {
    case ShiftElementKind::brake:
      return translated("brake %1", {std::string(id)});
    case ShiftElementKind::clutch:
      return translated("clutch %1", {std::string(id)});
    case ShiftElementKind::freewheel:
      return translated("freewheel %1", {std::string(id)});
  }
  GEARGRAPH_REQUIRE(false);
}

std::string_view loadSharingName(LoadSharing sharing) {
  return sharing == LoadSharing::stiffness ? "stiffness" : "none";
}

std::optional<LoadSharing> loadSharingFrom(std::string_view name) {
  for (const LoadSharing sharing : {LoadSharing::none, LoadSharing::stiffness})
    if (name == loadSharingName(sharing)) return sharing;
  return std::nullopt;
}

int View::colorNumber(LinkId link, int label) const {
  if (label == 0 || colors.empty()) return label;
  const auto found = colors.find(link);
  return found == colors.end() ? label : found->second;
}

const Link* Mechanism::find(LinkId id) const {
  return findIn(links, id);
}
const Axis* Mechanism::find(AxisId id) const {
  return findIn(axes, id);
}
const TurningJoint* Mechanism::find(JointId id) const {
  return findIn(turningJoints, id);
}
const GearMesh* Mechanism::find(MeshId id) const {
  return findIn(gearMeshes, id);
}
const Wheel* Mechanism::find(WheelId id) const {
  return findIn(wheels, id);
}
const ShiftElement* Mechanism::find(ShiftElementId id) const {
  return findIn(couplings, id);
}
const CanvasNote* Mechanism::find(NoteId id) const {
  return findIn(view.notes, id);
}

JointLimits opposite(const JointLimits& limits) {
  const auto negated = [](const std::optional<Number>& end) -> std::optional<Number> {
    if (!end) return std::nullopt;
    return Number(-end->exact());
  };
  return {negated(limits.high), negated(limits.low)};
}

Mechanism emptyMechanism() {
  Mechanism mechanism;
  mechanism.links.push_back({LinkId("0"), "ground"});
  return mechanism;
}

std::optional<std::string> labelOf(const Mechanism& mechanism, const ElementId& element) {
  std::optional<int> position;
  switch (element.kind) {
    case ElementKind::link:
      position = positionIn(mechanism.links, element.id);
      break;
    case ElementKind::turningJoint:
      position = positionIn(mechanism.turningJoints, element.id);
      if (position) position = mechanism.jointLabel(*position);
      break;
    case ElementKind::gearMesh:
      position = positionIn(mechanism.gearMeshes, element.id);
      if (position) position = mechanism.meshLabel(*position);
      break;
    default:
      return element.id.text();
  }
  if (!position) return std::nullopt;
  return std::to_string(*position);
}

}  // namespace geargraph
