#include "core/mechanism/model/edits.h"

#include <algorithm>
#include <set>
#include <unordered_set>

#include "core/foundations/base/contract.h"
#include "core/foundations/base/position_index.h"
#include "core/foundations/base/text_lists.h"
#include "core/foundations/base/translation.h"
#include "core/mechanism/model/arrow_flips.h"
#include "core/mechanism/model/fresh_ids.h"
#include "core/mechanism/model/limits.h"
#include "core/mechanism/model/link_colors.h"
#include "core/mechanism/model/load_edits.h"
#include "core/mechanism/model/rejections.h"
#include "core/mechanism/model/validate.h"

namespace geargraph {
namespace {

constexpr std::size_t kMaxNamedInALoop = 8;

template <class Element, class ElementIdType>
Element* findIn(std::vector<Element>& list, ElementIdType id) {
  const auto found = std::find_if(list.begin(), list.end(), [id](const Element& e) { return e.id == id; });
  return found == list.end() ? nullptr : &*found;
}

/// Loads and balances go with the joint, the link or the axis that they name.
void dropLoads(Mechanism& mechanism, const std::unordered_set<ElementId>& gone) {
  std::unordered_set<InternedString> joints;
  for (const TurningJoint& joint : mechanism.turningJoints) joints.insert(joint.id.atom());
  const auto goesWith = [&](LinkId link, const std::optional<AxisId>& axis) {
    return gone.contains(link) || (axis && gone.contains(*axis));
  };
  std::erase_if(mechanism.loads, [&](const Load& load) {
    if (!load.id.empty() && gone.contains(load.id)) return true;
    if (const auto* inJoint = std::get_if<JointTorque>(&load.action))
      return !joints.contains(inJoint->joint.atom());
    if (const auto* torque = std::get_if<LinkTorque>(&load.action))
      return goesWith(torque->link, torque->axis);
    return gone.contains(std::get<LinkForce>(load.action).link);
  });
  if (!mechanism.balances) return;
  std::erase_if(*mechanism.balances, [&](const HoldingTorque& balance) {
    if (const auto* joint = std::get_if<JointId>(&balance.at)) return !joints.contains(joint->atom());
    const auto& onLink = std::get<HoldingTorque::OnLink>(balance.at);
    return goesWith(onLink.link, onLink.axis);
  });
  if (mechanism.balances->empty()) mechanism.balances.reset();
}

bool bearsLoad(const Mechanism& mechanism, LinkId link) {
  const bool loaded = std::any_of(mechanism.loads.begin(), mechanism.loads.end(),
                                  [&](const Load& load) { return linkOf(load) == link; });
  if (loaded || !mechanism.balances) return loaded;
  return std::any_of(mechanism.balances->begin(), mechanism.balances->end(),
                     [&](const HoldingTorque& balance) {
                       const auto* onLink = std::get_if<HoldingTorque::OnLink>(&balance.at);
                       return onLink != nullptr && onLink->link == link;
                     });
}

void dropUnusedAxes(Mechanism& mechanism, const std::set<AxisId>& candidates) {
  std::set<AxisId> used;
  for (const TurningJoint& joint : mechanism.turningJoints) used.insert(joint.axis);
  forEachLoadAxis(mechanism, [&](std::optional<AxisId>& axis) {
    if (axis) used.insert(*axis);
  });
  std::erase_if(mechanism.axes,
                [&](const Axis& axis) { return candidates.contains(axis.id) && !used.contains(axis.id); });
}

Expected<Mechanism> withPlaces(Mechanism mechanism, std::map<LinkId, CanvasPoint> View::*drawing,
                               std::span<const std::pair<LinkId, CanvasPoint>> nodes) {
  const PositionIndex<LinkTag> links(mechanism.links);
  for (const auto& [link, point] : nodes) {
    if (links.positionOf(link) < 0) return unknownElement(link);
    (mechanism.view.*drawing)[link] = point;
  }
  return mechanism;
}

/// Why a joint is rejected, in the labels of the document as it is: the one it would have had may be a
/// mesh's.
std::string loopRejection(const Mechanism& edited, JointId added, const std::vector<ElementId>& loop) {
  const TurningJoint& joint = *edited.find(added);
  std::vector<std::string> with;
  for (std::size_t j = 0; j < edited.turningJoints.size(); ++j) {
    const ElementId each = edited.turningJoints[j].id;
    if (each != ElementId(added) && std::find(loop.begin(), loop.end(), each) != loop.end())
      with.push_back(std::to_string(edited.jointLabel(static_cast<int>(j))));
  }
  const std::string tail = *labelOf(edited, joint.tail);
  const std::string head = *labelOf(edited, joint.head);
  const std::string others = listed(with, kMaxNamedInALoop);
  if (with.empty())
    return translated(
        "A turning joint from link %1 to link %2 would close a loop. The turning joints have to be a "
        "tree: draw a gear mesh instead.",
        {tail, head});
  return with.size() == 1
             ? translated(
                   "A turning joint from link %1 to link %2 would close a loop with joint %3. The turning "
                   "joints have to be a tree: draw a gear mesh instead.",
                   {tail, head, others})
             : translated(
                   "A turning joint from link %1 to link %2 would close a loop with joints %3. The turning "
                   "joints have to be a tree: draw a gear mesh instead.",
                   {tail, head, others});
}

/// The first diagnostic that the edited mechanism has and `before` had not, as a rejection; else the
/// mechanism.
Expected<Mechanism> unlessLoop(Mechanism edited, JointId added) {
  for (Diagnostic& diagnostic : treeDiagnostics(edited)) {
    if (diagnostic.code != Code::turningLoop) continue;
    const auto& blamed = diagnostic.elements;
    if (std::find(blamed.begin(), blamed.end(), ElementId(added)) == blamed.end()) continue;
    diagnostic.message = loopRejection(edited, added, blamed);
    return std::move(diagnostic);
  }
  return edited;
}

}  // namespace

Expected<Mechanism> withLink(Mechanism mechanism, CanvasPoint at, std::string name) {
  const LinkColors colors(mechanism);
  const LinkId id(freshId(mechanism));
  mechanism.links.push_back({id, std::move(name)});
  mechanism.view.nodes[id] = at;
  colors.keepIn(mechanism);
  return mechanism;
}

Expected<Mechanism> withTurningJoint(Mechanism mechanism, LinkId tail, LinkId head, AxisId axis) {
  if (mechanism.find(tail) == nullptr) return unknownElement(tail);
  if (mechanism.find(head) == nullptr) return unknownElement(head);
  if (tail == head) {
    return rejection(Code::selfJoint, translated("A turning joint needs two different links."), {tail});
  }
  if (axis.empty()) {
    axis = freshAxisIds(mechanism, 1).front();
    mechanism.axes.push_back({axis, {}, {}});
  } else if (mechanism.find(axis) == nullptr) {
    return unknownElement(axis);
  }
  const JointId id(freshId(mechanism));
  mechanism.turningJoints.push_back({id, tail, head, axis, Number(0)});
  return unlessLoop(std::move(mechanism), id);
}

Expected<Mechanism> withGearMesh(Mechanism mechanism, LinkId tail, LinkId head, int tailTeeth,
                                 int headTeeth) {
  if (mechanism.find(tail) == nullptr) return unknownElement(tail);
  if (mechanism.find(head) == nullptr) return unknownElement(head);
  if (tail == head) {
    return rejection(Code::selfJoint, translated("A gear mesh needs two different links."), {tail});
  }
  GearMesh mesh;
  mesh.id = MeshId(freshId(mechanism));
  mesh.tail = tail;
  mesh.head = head;
  const MeshId id = mesh.id;
  mechanism.gearMeshes.push_back(std::move(mesh));
  return withTeeth(std::move(mechanism), id, tailTeeth, headTeeth);
}

Expected<Mechanism> withGearAttached(Mechanism mechanism, LinkId gear, LinkId carrier,
                                     std::optional<CanvasPoint> at) {
  if (mechanism.find(gear) == nullptr) return unknownElement(gear);
  const LinkColors colors(mechanism);
  const LinkId link(freshId(mechanism));
  mechanism.links.push_back({link, {}});
  if (at) mechanism.view.nodes[link] = *at;
  colors.keepIn(mechanism);
  Expected<Mechanism> turning = withTurningJoint(std::move(mechanism), carrier, link);
  if (!turning) return turning;
  return withGearMesh(std::move(turning).value(), gear, link);
}

Expected<Mechanism> withoutElements(Mechanism mechanism, std::span<const ElementId> elements) {
  const std::unordered_set<ElementId> gone(elements.begin(), elements.end());
  const LinkId ground = mechanism.links.front().id;
  if (gone.contains(ground)) {
    return rejection(Code::schema,
                     translated("The ground cannot be deleted; make another link the ground first."),
                     {ground});
  }
  const LinkColors colors(mechanism);
  const auto linkGone = [&](LinkId link) { return gone.contains(link); };
  std::set<AxisId> freed;
  for (const ElementId& element : elements) {
    if (element.kind == ElementKind::axis) freed.insert(AxisId(element.id));
  }

  std::erase_if(mechanism.turningJoints, [&](const TurningJoint& joint) {
    const bool goes =
        gone.contains(joint.id) || linkGone(joint.tail) || linkGone(joint.head) || gone.contains(joint.axis);
    if (goes) freed.insert(joint.axis);
    return goes;
  });
  std::erase_if(mechanism.wheels,
                [&](const Wheel& wheel) { return gone.contains(wheel.id) || linkGone(wheel.link); });
  std::erase_if(mechanism.gearMeshes, [&](const GearMesh& mesh) {
    return gone.contains(mesh.id) || linkGone(mesh.tail) || linkGone(mesh.head);
  });
  for (GearMesh& mesh : mechanism.gearMeshes) {
    if (mesh.tailWheel && mechanism.find(*mesh.tailWheel) == nullptr) mesh.tailWheel.reset();
    if (mesh.headWheel && mechanism.find(*mesh.headWheel) == nullptr) mesh.headWheel.reset();
  }
  std::erase_if(mechanism.links, [&](const Link& link) { return linkGone(link.id); });
  for (auto* const nodes : {&mechanism.view.nodes, &mechanism.view.ttNodes})
    std::erase_if(*nodes, [&](const auto& node) { return linkGone(node.first); });
  std::erase_if(mechanism.view.colors, [&](const auto& color) { return linkGone(color.first); });
  colors.keepIn(mechanism);
  std::erase_if(mechanism.view.notes, [&](const CanvasNote& note) { return gone.contains(note.id); });

  std::erase_if(mechanism.couplings, [&](const ShiftElement& coupling) {
    return gone.contains(coupling.id) || std::any_of(coupling.links.begin(), coupling.links.end(), linkGone);
  });
  std::unordered_set<InternedString> couplings;
  for (const ShiftElement& coupling : mechanism.couplings) couplings.insert(coupling.id.atom());
  const auto couplingGone = [&](ShiftElementId id) { return !couplings.contains(id.atom()); };
  std::erase_if(mechanism.engaged, couplingGone);
  for (ShiftState& state : mechanism.states) {
    std::erase_if(state.engaged, couplingGone);
    if (state.drive && linkGone(*state.drive)) state.drive.reset();
    if (state.driven && linkGone(*state.driven)) state.driven.reset();
  }
  if (mechanism.inputs) {
    std::unordered_set<InternedString> joints;
    for (const TurningJoint& joint : mechanism.turningJoints) joints.insert(joint.id.atom());
    std::erase_if(*mechanism.inputs,
                  [&](const Input& input) { return !joints.contains(input.joint.atom()); });
    if (mechanism.inputs->empty()) mechanism.inputs.reset();
  }
  dropLoads(mechanism, gone);
  dropUnusedAxes(mechanism, freed);
  return mechanism;
}

Expected<Mechanism> withFlipped(Mechanism mechanism, const ElementId& element) {
  if (element.kind == ElementKind::turningJoint) {
    TurningJoint* joint = findIn(mechanism.turningJoints, JointId(element.id));
    if (joint == nullptr) return unknownElement(element);
    flip(*joint);
    for (Load& load : mechanism.loads) flipOnJoint(load, joint->id);
    return mechanism;
  }
  GearMesh* mesh =
      element.kind == ElementKind::gearMesh ? findIn(mechanism.gearMeshes, MeshId(element.id)) : nullptr;
  if (mesh == nullptr) return unknownElement(element);
  flip(*mesh);
  return mechanism;
}

Expected<Mechanism> withName(Mechanism mechanism, const ElementId& element, const std::string& name) {
  if (element.kind == ElementKind::link) {
    Link* link = findIn(mechanism.links, LinkId(element.id));
    if (link == nullptr) return unknownElement(element);
    link->name = name;
    return mechanism;
  }
  if (element.kind != ElementKind::axis) {
    return rejection(Code::schema,
                     translated("Only links and axes bear names; the others bear the paper's labels."),
                     {element});
  }
  const AxisId from(element.id);
  const AxisId to{name};
  Axis* axis = findIn(mechanism.axes, from);
  if (axis == nullptr) return unknownElement(element);
  if (to == from) return mechanism;
  if (to.empty()) return rejection(Code::schema, translated("An axis needs a name."), {element});
  if (mechanism.find(to) != nullptr) {
    return rejection(Code::duplicateId, translated("There is an axis \"%1\" already.", {name}), {to});
  }
  axis->id = to;
  for (TurningJoint& joint : mechanism.turningJoints) {
    if (joint.axis == from) joint.axis = to;
  }
  forEachLoadAxis(mechanism, [&](std::optional<AxisId>& named) {
    if (named == from) named = to;
  });
  return mechanism;
}

Expected<Mechanism> withNodesMoved(Mechanism mechanism,
                                   std::span<const std::pair<LinkId, CanvasPoint>> nodes) {
  return withPlaces(std::move(mechanism), &View::nodes, nodes);
}

Expected<Mechanism> withTtNodesMoved(Mechanism mechanism,
                                     std::span<const std::pair<LinkId, CanvasPoint>> nodes) {
  return withPlaces(std::move(mechanism), &View::ttNodes, nodes);
}

Expected<Mechanism> withTeeth(Mechanism mechanism, MeshId mesh, int tailTeeth, int headTeeth) {
  GearMesh* found = findIn(mechanism.gearMeshes, mesh);
  if (found == nullptr) return unknownElement(mesh);
  found->tailTeeth = tailTeeth;
  found->headTeeth = headTeeth;
  for (const int teeth : {tailTeeth, headTeeth}) {
    if (teeth < kMinTeeth || teeth > kMaxTeeth) {
      return rejection(Code::schema,
                       translated("A gear has 1 to 100,000 teeth, not %1.", {std::to_string(teeth)}), {mesh});
    }
  }
  return mechanism;
}

namespace {

constexpr int kUsualLead = 5;        // of a screw, in the document's unit
constexpr int kUsualRackModule = 2;  // of a rack

}  // namespace

Expected<Mechanism> withMeshKind(Mechanism mechanism, MeshId mesh, std::optional<MeshKind> kind) {
  GearMesh* found = findIn(mechanism.gearMeshes, mesh);
  if (found == nullptr) return unknownElement(mesh);
  const bool hadNoTeeth = !statesTeeth(*found);
  found->kind = kind;
  const PairKind& now = pairKind(saidKind(*found));
  if (!now.slides || now.hasTeeth) found->lead.reset();
  if (now.slides && !now.hasTeeth) {
    if (!found->lead) found->lead = Number(Rational(kUsualLead));
    found->module.reset();
    found->helixAngle.reset();
  }
  if (now.slides && now.hasTeeth && !found->module && !found->pitch)
    found->module = Number(Rational(kUsualRackModule));
  if (!now.canCross) {
    found->crossed = false;
    if (!now.slides || !now.hasTeeth) found->pitch.reset();
    found->tailDiameter.reset();
    found->headDiameter.reset();
  }
  if (!now.touches) {
    found->pitchPoint.reset();
    found->friction.reset();
  }
  if (hasSkewAxes(saidKind(*found))) {
    found->herringbone = false;
    if (now.isThreaded) found->helixAngle.reset();
  }
  if (!now.statesHelix) {
    found->herringbone = false;
    found->helixAngle.reset();
    found->hand.reset();
  }
  settleWeights(*found);
  if (hadNoTeeth && statesTeeth(*found)) {  // 1 : 1 are no teeth
    const GearMesh usual;
    const int times = std::max(1, usual.tailTeeth / std::min(found->tailTeeth, found->headTeeth));
    if (std::max(found->tailTeeth, found->headTeeth) <= kMaxTeeth / times) {
      found->tailTeeth *= times;
      found->headTeeth *= times;
    }
  }
  return mechanism;
}

Expected<Mechanism> withHelixAngle(Mechanism mechanism, MeshId mesh, std::optional<Number> degrees) {
  GearMesh* found = findIn(mechanism.gearMeshes, mesh);
  if (found == nullptr) return unknownElement(mesh);
  if (degrees && (degrees->exact().sign() < 0 || degrees->exact() >= Rational(90))) {
    return rejection(Code::schema,
                     translated("The helix angle of a gear mesh is at least 0 and below 90 degrees."),
                     {mesh});
  }
  found->helixAngle = degrees && degrees->isZero() ? std::nullopt : std::move(degrees);
  return mechanism;
}

Expected<Mechanism> withHand(Mechanism mechanism, MeshId mesh, std::optional<Hand> hand) {
  GearMesh* found = findIn(mechanism.gearMeshes, mesh);
  if (found == nullptr) return unknownElement(mesh);
  found->hand = hand;
  return mechanism;
}

Expected<Mechanism> withHerringbone(Mechanism mechanism, MeshId mesh, bool herringbone) {
  GearMesh* found = findIn(mechanism.gearMeshes, mesh);
  if (found == nullptr) return unknownElement(mesh);
  found->herringbone = herringbone;
  return mechanism;
}

Expected<Mechanism> withCrossed(Mechanism mechanism, MeshId mesh, bool crossed) {
  GearMesh* found = findIn(mechanism.gearMeshes, mesh);
  if (found == nullptr) return unknownElement(mesh);
  GEARGRAPH_REQUIRE(!crossed || pairKind(saidKind(*found)).canCross);
  found->crossed = crossed;
  return mechanism;
}

Expected<Mechanism> withPitchPoint(Mechanism mechanism, MeshId mesh, std::optional<NumberTriple> pitchPoint) {
  GearMesh* found = findIn(mechanism.gearMeshes, mesh);
  if (found == nullptr) return unknownElement(mesh);
  found->pitchPoint = std::move(pitchPoint);
  return mechanism;
}

Expected<Mechanism> withAxisPlaced(Mechanism mechanism, AxisId axis, std::optional<NumberTriple> point,
                                   std::optional<NumberTriple> direction) {
  Axis* found = findIn(mechanism.axes, axis);
  if (found == nullptr) return unknownElement(axis);
  if (direction && isZero(*direction)) {
    return rejection(Code::schema, translated("The direction of axis %1 has length 0.", {axis.text()}),
                     {axis});
  }
  found->point = std::move(point);
  found->direction = std::move(direction);
  return checkedLimits(std::move(mechanism));
}

Expected<Mechanism> withJointAxis(Mechanism mechanism, JointId joint, AxisId axis) {
  TurningJoint* found = findIn(mechanism.turningJoints, joint);
  if (found == nullptr) return unknownElement(joint);
  if (mechanism.find(axis) == nullptr) return unknownElement(axis);
  const AxisId before = found->axis;
  found->axis = axis;
  dropUnusedAxes(mechanism, {before});
  return mechanism;
}

Expected<Mechanism> withNewAxis(Mechanism mechanism, std::span<const JointId> joints) {
  GEARGRAPH_REQUIRE(!joints.empty());
  const TurningJoint* first = mechanism.find(joints.front());
  if (first == nullptr) return unknownElement(joints.front());
  Axis axis = *mechanism.find(first->axis);
  axis.id = freshAxisIds(mechanism, 1).front();
  const AxisId id = axis.id;
  mechanism.axes.push_back(std::move(axis));
  for (const JointId joint : joints) {
    Expected<Mechanism> next = withJointAxis(std::move(mechanism), joint, id);
    if (!next) return next;
    mechanism = std::move(next).value();
  }
  return mechanism;
}

Expected<Mechanism> withOffset(Mechanism mechanism, JointId joint, const Number& offset) {
  TurningJoint* found = findIn(mechanism.turningJoints, joint);
  if (found == nullptr) return unknownElement(joint);
  found->offset = offset;
  return mechanism;
}

Expected<Mechanism> withJointLimits(Mechanism mechanism, JointId joint, const JointLimits& limits) {
  TurningJoint* found = findIn(mechanism.turningJoints, joint);
  if (found == nullptr) return unknownElement(joint);
  if (const auto problem = limitsProblem(limits)) return rejection(Code::schema, *problem, {joint});
  found->limits = limits;
  return mechanism;
}

Expected<Mechanism> withInputs(Mechanism mechanism, std::optional<std::vector<Input>> inputs) {
  if (inputs) {
    const PositionIndex<JointTag> joints(mechanism.turningJoints);
    std::set<JointId> seen;
    for (const Input& input : *inputs) {
      if (joints.positionOf(input.joint) < 0) return unknownElement(input.joint);
      if (!seen.insert(input.joint).second) {
        return rejection(Code::duplicateId, translated("The joint is an input already."), {input.joint});
      }
    }
  }
  mechanism.inputs = std::move(inputs);
  return mechanism;
}

Expected<Mechanism> withGround(Mechanism mechanism, LinkId link) {
  const auto found = std::find_if(mechanism.links.begin(), mechanism.links.end(),
                                  [link](const Link& candidate) { return candidate.id == link; });
  if (found == mechanism.links.end()) return unknownElement(link);
  if (bearsLoad(mechanism, link)) {
    return rejection(
        Code::schema,
        translated("Loads or balances act on this link, and the ground can have none: remove them first."),
        {link});
  }
  const LinkColors colors(mechanism);
  std::rotate(mechanism.links.begin(), found, found + 1);
  colors.keepIn(mechanism);
  return mechanism;
}

}  // namespace geargraph
