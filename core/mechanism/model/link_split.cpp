#include <algorithm>
#include <map>
#include <set>
#include <unordered_set>

#include "core/foundations/base/disjoint_sets.h"
#include "core/foundations/base/position_index.h"
#include "core/foundations/base/translation.h"
#include "core/mechanism/model/fresh_ids.h"
#include "core/mechanism/model/joint_forest.h"
#include "core/mechanism/model/link_colors.h"
#include "core/mechanism/model/link_edits.h"
#include "core/mechanism/model/rejections.h"
#include "core/mechanism/model/validate.h"

namespace geargraph {
namespace {

bool isOf(LinkId link, const TurningJoint& joint) {
  return joint.tail == link || joint.head == link;
}
bool isOf(LinkId link, const GearMesh& mesh) {
  return mesh.tail == link || mesh.head == link;
}
bool isOf(LinkId link, const ShiftElement& coupling) {
  return std::find(coupling.links.begin(), coupling.links.end(), link) != coupling.links.end();
}

/// Is this joint, mesh or coupling one of the link? Cost: O(the length of its list).
bool isOf(const Mechanism& mechanism, LinkId link, const ElementId& element) {
  const auto isItsOwn = [&](const auto* found) { return found != nullptr && isOf(link, *found); };
  switch (element.kind) {
    case ElementKind::turningJoint:
      return isItsOwn(mechanism.find(JointId(element.id)));
    case ElementKind::gearMesh:
      return isItsOwn(mechanism.find(MeshId(element.id)));
    case ElementKind::coupling:
      return isItsOwn(mechanism.find(ShiftElementId(element.id)));
    default:
      return false;
  }
}

bool exists(const Mechanism& mechanism, const ElementId& element) {
  switch (element.kind) {
    case ElementKind::turningJoint:
      return mechanism.find(JointId(element.id)) != nullptr;
    case ElementKind::gearMesh:
      return mechanism.find(MeshId(element.id)) != nullptr;
    case ElementKind::coupling:
      return mechanism.find(ShiftElementId(element.id)) != nullptr;
    default:
      return true;  // told as one that is no part of the link
  }
}

/// The joint on which a link is carried towards the ground; null if there is none.
const TurningJoint* carryingJointOf(const Mechanism& mechanism, LinkId link) {
  const PositionIndex<LinkTag> links(mechanism.links);
  const int joint = JointForest(mechanism).carryingJoint(links.positionOf(link));
  return joint < 0 ? nullptr : &mechanism.turningJoints[static_cast<std::size_t>(joint)];
}

/// Gives the moved meshes wheels of the new link: those that only they name go along, others are copied.
void moveWheels(Mechanism& mechanism, LinkId from, LinkId to, const std::unordered_set<ElementId>& moved) {
  std::map<WheelId, WheelId> wheels;
  std::set<WheelId> left;
  const auto forEachEnd = [&](bool isMoved, const auto& use) {
    for (GearMesh& mesh : mechanism.gearMeshes) {
      if (moved.contains(mesh.id) != isMoved) continue;
      if (mesh.tailWheel) use(*mesh.tailWheel);
      if (mesh.headWheel) use(*mesh.headWheel);
    }
  };
  forEachEnd(false, [&](const WheelId& wheel) { left.insert(wheel); });
  forEachEnd(true, [&](WheelId& wheel) {
    const auto found = std::find_if(mechanism.wheels.begin(), mechanism.wheels.end(),
                                    [&](const Wheel& each) { return each.id == wheel; });
    if (const auto known = wheels.find(wheel); known != wheels.end()) {
      wheel = known->second;
    } else if (found != mechanism.wheels.end() && found->link == from) {
      const WheelId before = wheel;
      if (left.contains(before)) {
        Wheel copy = *found;
        for (int i = 2; mechanism.find(copy.id) != nullptr; ++i)
          copy.id = WheelId(before.text() + "." + std::to_string(i));
        copy.link = to;
        wheel = copy.id;
        mechanism.wheels.push_back(std::move(copy));
      } else {
        found->link = to;
      }
      wheels.emplace(before, wheel);
    }
  });
}

}  // namespace

Expected<Mechanism> withLinkSplit(Mechanism mechanism, LinkId link, std::span<const ElementId> moving,
                                  std::optional<CanvasPoint> at) {
  const Link* const before = mechanism.find(link);
  if (before == nullptr) return unknownElement(link);
  if (link == mechanism.links.front().id) {
    return rejection(Code::schema,
                     translated("The ground cannot be split: nothing says about which axis its part turns."),
                     {link});
  }
  const std::unordered_set<ElementId> moved(moving.begin(), moving.end());
  for (const ElementId& element : moving) {
    if (!exists(mechanism, element)) return unknownElement(element);
    if (isOf(mechanism, link, element)) continue;
    return rejection(Code::schema,
                     translated("\"%1\" is no joint, mesh or coupling of link %2.",
                                {element.id.text(), labelOrId(mechanism, link)}),
                     {element, link});
  }
  const TurningJoint* const carrying = carryingJointOf(mechanism, link);
  if (carrying == nullptr) {
    return rejection(
        Code::schema,
        translated("Link %1 turns on no other link, so that its parts have no axis: draw its joint first.",
                   {labelOrId(mechanism, link)}),
        {link});
  }
  // The joint that carries the link is there for both parts.
  std::size_t goes = 0;
  std::size_t stays = 0;
  const auto count = [&](const auto& list) {
    for (const auto& each : list) {
      if (isOf(link, each) && ElementId(each.id) != ElementId(carrying->id))
        ++(moved.contains(each.id) ? goes : stays);
    }
  };
  count(mechanism.turningJoints);
  count(mechanism.gearMeshes);
  count(mechanism.couplings);
  if (goes == 0 || stays == 0) {
    return rejection(Code::schema,
                     translated("To split link %1, choose some of its joints and meshes, and leave others: "
                                "the new link takes those that you choose.",
                                {labelOrId(mechanism, link)}),
                     {link});
  }

  const LinkColors colors(mechanism);
  const std::vector<std::string> ids = freshIds(mechanism, 2);
  const LinkId part(ids[0]);
  TurningJoint joint = *carrying;
  joint.id = JointId(ids[1]);
  joint.limits = {};
  joint.unknown = {};
  if (!moved.contains(carrying->id)) (joint.tail == link ? joint.tail : joint.head) = part;
  const auto move = [&](LinkId& end) {
    if (end == link) end = part;
  };
  for (TurningJoint& each : mechanism.turningJoints) {
    if (!moved.contains(each.id)) continue;
    move(each.tail);
    move(each.head);
  }
  for (GearMesh& mesh : mechanism.gearMeshes) {
    if (!moved.contains(mesh.id)) continue;
    move(mesh.tail);
    move(mesh.head);
  }
  for (ShiftElement& coupling : mechanism.couplings) {
    if (!moved.contains(coupling.id)) continue;
    for (LinkId& end : coupling.links) move(end);
  }
  mechanism.links.push_back({part, {}});
  mechanism.turningJoints.push_back(std::move(joint));
  moveWheels(mechanism, link, part, moved);
  if (at) mechanism.view.nodes[part] = *at;
  colors.keepIn(mechanism);
  return mechanism;
}

std::vector<ElementId> lastSideOf(const Mechanism& mechanism, LinkId link) {
  if (mechanism.find(link) == nullptr || link == mechanism.links.front().id) return {};
  const TurningJoint* const carrying = carryingJointOf(mechanism, link);
  if (carrying == nullptr) return {};
  const PositionIndex<LinkTag> links(mechanism.links);
  const LinkId carrier = carrying->tail == link ? carrying->head : carrying->tail;
  DisjointSets groups(mechanism.links.size());
  const auto isOpen = [&](LinkId each) {
    return each != link && each != carrier && each != mechanism.links.front().id;
  };
  const auto position = [&](LinkId each) { return static_cast<std::size_t>(links.positionOf(each)); };
  const auto join = [&](LinkId a, LinkId b) {
    if (isOpen(a) && isOpen(b)) groups.join(position(a), position(b));
  };
  for (const TurningJoint& joint : mechanism.turningJoints) join(joint.tail, joint.head);
  for (const GearMesh& mesh : mechanism.gearMeshes) join(mesh.tail, mesh.head);

  // What is on the link, by the group of its other end; what ends on the carrier or the ground is no side.
  struct Side {
    std::vector<ElementId> elements;
    std::size_t last = 0;  ///< position of the link that was drawn last
  };
  std::map<std::size_t, Side> sides;
  const auto add = [&](const ElementId& element, LinkId a, LinkId b) {
    if (a != link && b != link) return;
    const LinkId end = a == link ? b : a;
    if (isOpen(end)) sides[groups.root(position(end))].elements.push_back(element);
  };
  for (const TurningJoint& joint : mechanism.turningJoints) add(joint.id, joint.tail, joint.head);
  for (const GearMesh& mesh : mechanism.gearMeshes) add(mesh.id, mesh.tail, mesh.head);
  if (sides.size() < 2) return {};
  for (const Link& each : mechanism.links) {
    const auto side = isOpen(each.id) ? sides.find(groups.root(position(each.id))) : sides.end();
    if (side != sides.end()) side->second.last = position(each.id);
  }
  return std::max_element(sides.begin(), sides.end(),
                          [](const auto& a, const auto& b) { return a.second.last < b.second.last; })
      ->second.elements;
}

}  // namespace geargraph
