#include "core/mechanism/model/drawn_mesh.h"

#include <algorithm>
#include <deque>
#include <map>
#include <optional>
#include <vector>

#include "core/mechanism/model/axis_letters.h"
#include "core/mechanism/model/edits.h"

namespace geargraph {
namespace {

constexpr int kTeeth = 20;  ///< of a wheel that nothing is known of

/// One turning joint of a path, and the link it leads to.
struct Step {
  const TurningJoint* joint = nullptr;
  LinkId to;
};

/// The turning joints from one link to another; empty where none lead there.
std::vector<Step> pathBetween(const Mechanism& mechanism, LinkId from, LinkId to) {
  std::map<LinkId, std::vector<const TurningJoint*>> joints;
  for (const TurningJoint& joint : mechanism.turningJoints) {
    joints[joint.tail].push_back(&joint);
    joints[joint.head].push_back(&joint);
  }
  std::map<LinkId, const TurningJoint*> reached{{from, nullptr}};
  std::deque<LinkId> queue{from};
  while (!queue.empty() && !reached.contains(to)) {
    const LinkId link = queue.front();
    queue.pop_front();
    for (const TurningJoint* joint : joints[link]) {
      const LinkId other = joint->tail == link ? joint->head : joint->tail;
      if (reached.emplace(other, joint).second) queue.push_back(other);
    }
  }
  std::vector<Step> path;
  if (!reached.contains(to)) return path;
  for (LinkId link = to; link != from;) {
    const TurningJoint* joint = reached[link];
    path.push_back({joint, link});
    link = joint->tail == link ? joint->head : joint->tail;
  }
  std::reverse(path.begin(), path.end());
  return path;
}

int changesOfAxis(const std::vector<Step>& path) {
  int changes = 0;
  for (std::size_t i = 1; i < path.size(); ++i)
    changes += path[i].joint->axis != path[i - 1].joint->axis ? 1 : 0;
  return changes;
}

bool isPlaced(const Mechanism& mechanism, AxisId axis) {
  const Axis& found = *mechanism.find(axis);
  return found.point || found.direction;
}

Expected<Mechanism> withAxesMerged(Mechanism mechanism, AxisId kept, AxisId gone) {
  const Mechanism before = mechanism;
  std::vector<JointId> joints;
  for (const TurningJoint& joint : mechanism.turningJoints) {
    if (joint.axis == gone) joints.push_back(joint.id);
  }
  for (const JointId joint : joints) {
    Expected<Mechanism> next = withJointAxis(std::move(mechanism), joint, kept);
    if (!next) return next;
    mechanism = std::move(next).value();
  }
  return withAxisLettersAsBefore(before, std::move(mechanism));
}

/// The two joints by which the path leaves one link turn about one axis, where that leaves one change.
Expected<Mechanism> withAxesGuessed(Mechanism mechanism, LinkId tail, LinkId head) {
  const std::vector<Step> path = pathBetween(mechanism, tail, head);
  if (changesOfAxis(path) != 2) return mechanism;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const TurningJoint& in = *path[i - 1].joint;
    const TurningJoint& out = *path[i].joint;
    const bool leaveOneLink = in.tail == path[i - 1].to && out.tail == path[i - 1].to;
    if (!leaveOneLink || in.axis == out.axis) continue;
    const bool outIsPlaced = isPlaced(mechanism, out.axis);
    if (outIsPlaced && isPlaced(mechanism, in.axis)) return mechanism;
    const AxisId kept = outIsPlaced ? out.axis : in.axis;
    const AxisId gone = outIsPlaced ? in.axis : out.axis;
    return withAxesMerged(std::move(mechanism), kept, gone);
  }
  return mechanism;
}

/// The carrier of two gears and the axes on which they sit on it.
struct CarrierAxes {
  LinkId carrier;
  AxisId tailAxis;
  AxisId headAxis;
};

std::optional<CarrierAxes> seatOf(const Mechanism& mechanism, LinkId tail, LinkId head) {
  const std::vector<Step> path = pathBetween(mechanism, tail, head);
  if (changesOfAxis(path) != 1) return std::nullopt;
  const auto change = std::adjacent_find(
      path.begin(), path.end(), [](const Step& a, const Step& b) { return a.joint->axis != b.joint->axis; });
  return CarrierAxes{change->to, path.front().joint->axis, path.back().joint->axis};
}

/// A mesh that is there already, under the same carrier, seen from one of its gears.
struct Neighbour {
  const GearMesh* mesh = nullptr;
  LinkId gear;
  AxisId axis;
  int teeth = 0;
  LinkId otherGear;
  AxisId otherAxis;
  int otherTeeth = 0;
};

std::vector<Neighbour> neighboursUnder(const Mechanism& mechanism, LinkId carrier) {
  std::vector<Neighbour> found;
  for (const GearMesh& mesh : mechanism.gearMeshes) {
    const auto seat = seatOf(mechanism, mesh.tail, mesh.head);
    if (!seat || seat->carrier != carrier) continue;
    found.push_back(
        {&mesh, mesh.tail, seat->tailAxis, mesh.tailTeeth, mesh.head, seat->headAxis, mesh.headTeeth});
    found.push_back(
        {&mesh, mesh.head, seat->headAxis, mesh.headTeeth, mesh.tail, seat->tailAxis, mesh.tailTeeth});
  }
  return found;
}

/// What is known of a new mesh from those that are there.
struct Guess {
  std::optional<int> tailTeeth;
  std::optional<int> headTeeth;
  std::optional<MeshKind> kind;
};

/// `planet` and `central`: the two sides of the new mesh, the planet's first.
std::optional<Guess> asSecondCentralGear(const std::vector<Neighbour>& neighbours, LinkId planet,
                                         AxisId planetAxis, LinkId central, AxisId centralAxis) {
  for (const Neighbour& first : neighbours) {
    const bool same = first.gear == planet && first.axis == planetAxis && first.otherAxis == centralAxis &&
                      first.otherGear != central;
    if (!same) continue;
    const auto second = pairKind(saidKind(*first.mesh)).secondCentral(first.teeth, first.otherTeeth);
    if (second) return Guess{first.teeth, second->teeth, second->kind};
  }
  return std::nullopt;
}

Guess guessOf(const Mechanism& mechanism, LinkId tail, LinkId head) {
  Guess guess;
  const auto seat = seatOf(mechanism, tail, head);
  if (!seat) return guess;
  const std::vector<Neighbour> neighbours = neighboursUnder(mechanism, seat->carrier);
  // On the ground it would be the last wheel of a reverted train.
  const bool turns = seat->carrier != mechanism.links.front().id;
  if (turns) {
    if (auto ring = asSecondCentralGear(neighbours, tail, seat->tailAxis, head, seat->headAxis)) return *ring;
    if (auto ring = asSecondCentralGear(neighbours, head, seat->headAxis, tail, seat->tailAxis)) {
      return {ring->headTeeth, ring->tailTeeth, ring->kind};
    }
  }
  for (const Neighbour& wheel : neighbours) {
    // The same gear again, and its partner identical to the one it meshes with already.
    const bool ofTail = wheel.gear == tail && wheel.axis == seat->tailAxis;
    const bool ofHead = wheel.gear == head && wheel.axis == seat->headAxis;
    if (ofTail) guess = {wheel.teeth, wheel.otherTeeth, wheel.mesh->kind};
    if (ofHead) guess = {wheel.otherTeeth, wheel.teeth, wheel.mesh->kind};
  }
  return guess;
}

}  // namespace

Expected<Mechanism> withDrawnMesh(Mechanism mechanism, LinkId tail, LinkId head) {
  const bool exist = mechanism.find(tail) != nullptr && mechanism.find(head) != nullptr && tail != head;
  if (!exist) return withGearMesh(std::move(mechanism), tail, head);
  Expected<Mechanism> fitting = withAxesGuessed(std::move(mechanism), tail, head);
  if (!fitting) return fitting;
  const Guess guess = guessOf(*fitting, tail, head);
  const auto teeth = [](const std::optional<int>& guessed) {
    return std::clamp(guessed.value_or(kTeeth), kMinTeeth, kMaxTeeth);
  };
  Expected<Mechanism> drawn =
      withGearMesh(std::move(fitting).value(), tail, head, teeth(guess.tailTeeth), teeth(guess.headTeeth));
  if (!drawn || !guess.kind) return drawn;
  const MeshId mesh = drawn->gearMeshes.back().id;
  return withMeshKind(std::move(drawn).value(), mesh, guess.kind);
}

}  // namespace geargraph
