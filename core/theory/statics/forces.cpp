#include "core/theory/statics/forces.h"

#include <algorithm>
#include <cmath>

#include "core/foundations/base/position_index.h"

namespace geargraph {
namespace {

/// Perpendicular to the pitch line in the plane of the axes (of a face gear along the radius of its pinion),
/// towards the axis of the smaller gear.
Vector3 towardsSmaller(const Placement& placement, const MeshGeometry& mesh) {
  const Vector3& tail = placement.lineOfClass(mesh.tailClass).direction;
  const Vector3& head = placement.lineOfClass(mesh.headClass).direction;
  const Vector3 pitchLine =
      (static_cast<double>(mesh.sign) * mesh.headTeeth) * tail - static_cast<double>(mesh.tailTeeth) * head;
  const bool isTail = std::abs(mesh.tailRadius) <= std::abs(mesh.headRadius);
  const Vector3 across =
      unit(cross(mesh.normal, pairKind(mesh.kind).hasFace ? (isTail ? tail : head) : pitchLine));
  const Vector3& axis = isTail ? tail : head;
  const Vector3 fromLine = isTail ? mesh.tailToPitch : mesh.tailToPitch - mesh.tailToHead;
  const Vector3 towards = dot(fromLine, axis) * axis - fromLine;
  return dot(across, towards) < 0 ? -1.0 * across : across;
}

/// The strand of a belt that is tight: that of the row, or its mirror image in the plane of both axes, which
/// has the same moments about them for the opposite force. `force.tangential` is set.
void pullAlongStrand(const Placement& placement, const MeshGeometry& mesh, ToothForce& force) {
  const Vector3& axis = placement.lineOfClass(mesh.tailClass).direction;
  const Vector3 apart = mesh.tailToHead - dot(mesh.tailToHead, axis) * axis;
  const Vector3 side = unit(cross(axis, apart));
  force.direction = side;
  force.force = force.tangential * mesh.normal;
  const bool pushes = dot(force.force, apart) > 0;
  if (!pushes || !pairKind(mesh.kind).canCross) return;
  const auto mirrored = [&](const Vector3& v) { return v - 2 * dot(v, side) * side; };
  force.force = -force.tangential * mirrored(mesh.normal);
  force.point = mesh.pitchPoint - 2 * dot(mesh.tailToPitch, side) * side;
}

/// Gears on skew axes: across the teeth, which e_c is in the plane that touches both cylinders, and apart
/// along the common perpendicular. Told in the tail gear's directions. `force.tangential` is that along e_c.
void pushAcross(const Placement& placement, const MeshGeometry& mesh, double pressureAngle,
                ToothForce& force) {
  const Vector3& axis = placement.lineOfClass(mesh.tailClass).direction;
  const Vector3 between = unit(cross(axis, placement.lineOfClass(mesh.headClass).direction));
  const Vector3 inPlane = force.tangential * mesh.normal;
  force.separating = std::abs(force.tangential) * std::tan(pressureAngle);
  force.direction = dot(between, mesh.tailToHead) < 0 ? -1.0 * between : between;
  force.force = inPlane + force.separating * force.direction;
  const double along = dot(inPlane, axis);
  force.axial = std::abs(along);
  force.axialDirection = (along < 0 ? -1.0 : 1.0) * axis;
  force.tangential *= std::cos(mesh.tailHelix);
}

/// A hypoid: across the teeth in its pitch plane, and apart along the normal of that. Its parts are told as
/// the tail's gear bears them, along the line of its cone. `force.tangential` is that along e_c.
void pushCones(const Placement& placement, const MeshGeometry& mesh, double pressureAngle,
               ToothForce& force) {
  const Vector3& axis = placement.lineOfClass(mesh.tailClass).direction;
  const Vector3& other = placement.lineOfClass(mesh.headClass).direction;
  const Vector3 fromHead = mesh.tailToPitch - mesh.tailToHead;
  const Vector3 tail = unit(cross(axis, mesh.tailToPitch));
  const Vector3 normal = unit(cross(tail, cross(other, fromHead)));
  const Vector3 towardsHead = dot(fromHead, other) * other - fromHead;
  const Vector3 inPlane = force.tangential * mesh.normal;
  force.separating = std::abs(force.tangential) * std::tan(pressureAngle);
  force.direction = dot(normal, towardsHead) < 0 ? -1.0 * normal : normal;
  force.force = inPlane + force.separating * force.direction;
  const Vector3 line = cross(normal, tail);
  const double along = dot(inPlane, line);
  force.axial = std::abs(along);
  force.axialDirection = (along < 0 ? -1.0 : 1.0) * line;
  force.tangential *= std::cos(mesh.tailHelix);
}

/// Without the components that are no more than the rounding of the sums they come from: -2e-15 N m beside 5.
Vector3 withoutRounding(Vector3 vector) {
  constexpr double kRounding = 1e-13;
  const double noise = kRounding * length(vector);
  for (double& component : vector) {
    if (std::abs(component) <= noise) component = 0;
  }
  return vector;
}

/// Sums the wrenches on links, moments about a point near the train.
class LinkWrenches {
 public:
  LinkWrenches(int links, Vector3 origin, double metres)
      : m_origin(origin),
        m_metres(metres),
        m_forces(static_cast<std::size_t>(links) + 1, Vector3{0, 0, 0}),
        m_moments(m_forces) {}

  void addForce(LinkOrdinal link, const Vector3& force, const Vector3& point) {
    add(m_forces[link], force);
    addCouple(link, m_metres * cross(point - m_origin, force));
  }
  void addCouple(LinkOrdinal link, const Vector3& couple) { add(m_moments[link], couple); }

  /// The links' wrenches become those of all links beyond: call from the leaves towards the ground.
  void pass(LinkOrdinal link, LinkOrdinal parent) {
    add(m_forces[parent], force(link));
    add(m_moments[parent], m_moments[link]);
  }
  [[nodiscard]] const Vector3& force(LinkOrdinal link) const { return m_forces[link]; }
  [[nodiscard]] Vector3 momentAbout(LinkOrdinal link, const Vector3& point) const {
    return m_moments[link] - m_metres * cross(point - m_origin, force(link));
  }

 private:
  static void add(Vector3& to, const Vector3& what) {
    for (std::size_t i = 0; i < 3; ++i) to[i] += what[i];
  }

  Vector3 m_origin;
  double m_metres;
  ByLink<Vector3> m_forces;
  ByLink<Vector3> m_moments;
};

class ForceSum {
 public:
  ForceSum(const Mechanism& mechanism, const KinematicModel& model, const Placement& placement, double metres,
           std::span<const HeldPart> held, std::span<const double> values, std::span<const char> determined)
      : m_mechanism(mechanism),
        m_model(model),
        m_placement(placement),
        m_held(held),
        m_values(values),
        m_determined(determined),
        m_wrenches(model.n(), placement.axes.empty() ? Vector3{} : placement.axes.front().point, metres),
        m_keys(static_cast<std::size_t>(model.n()) + 1, 0) {}

  void addMeshes(const std::vector<ToothForce>& forces, std::span<const MeshLoss> losses) {
    for (MeshOrdinal mesh = 0; mesh < m_model.c(); ++mesh) {
      const auto at = static_cast<std::size_t>(mesh);
      const MeshGeometry& geometry = *m_placement.meshes[at];
      m_wrenches.addForce(geometry.head, forces[at].force, forces[at].point);
      m_wrenches.addForce(geometry.tail, -1.0 * forces[at].force, forces[at].point);
      if (m_determined[at] == 0) mark(geometry.tail, geometry.head);
      if (losses.empty() || losses[at].driver == MeshLoss::Driver::none) continue;
      const bool tailDrives = losses[at].driver == MeshLoss::Driver::tail;
      const double lost = 1 - losses[at].efficiency.toDouble();
      const double couple = tailDrives ? -lost * geometry.sign * m_values[at] * geometry.headTeeth
                                       : lost * m_values[at] * geometry.tailTeeth;
      const Vector3& axis =
          m_placement.lineOfClass(tailDrives ? geometry.headClass : geometry.tailClass).direction;
      m_wrenches.addCouple(tailDrives ? geometry.head : geometry.tail, couple * axis);
      m_wrenches.addCouple(geometry.carrier, -couple * axis);
    }
  }

  void addLoads(const StaticsProblem& problem) {
    for (const AppliedTorque& load : problem.torques) {
      if (load.place.inJoint()) continue;  // it acts on both links of the joint, from within
      m_wrenches.addCouple(load.place.link, load.torque.toDouble() * unitDirection(load.place.direction));
    }
    for (const AppliedForce& load : problem.forces)
      m_wrenches.addForce(load.link, toDoubles(load.force), toDoubles(load.point));
  }

  void addHeld(const StaticsProblem& problem) {
    const PositionIndex<LinkTag> links(m_mechanism.links);
    for (std::size_t part = 0; part < m_held.size();) {
      const HeldPart& first = m_held[part];
      if (first.balance >= 0) {
        const TorquePlace& place = problem.balances[static_cast<std::size_t>(first.balance)];
        const auto at = static_cast<std::size_t>(m_model.c()) + part++;
        if (place.inJoint()) continue;
        m_wrenches.addCouple(place.link, m_values[at] * unitDirection(place.direction));
        if (m_determined[at] == 0) mark(place.link, 0);
        continue;
      }
      const ShiftElement& coupling = m_mechanism.couplings[first.coupling];
      const LinkOrdinal link = links.at(coupling.links.front());
      const int against = coupling.kind == ShiftElementKind::brake ? 0 : links.at(coupling.links.back());
      std::vector<std::pair<Vector3, double>> components;
      bool isDetermined = true;
      for (; part < m_held.size() && m_held[part].coupling == first.coupling; ++part) {
        const auto at = static_cast<std::size_t>(m_model.c()) + part;
        components.emplace_back(m_placement.axes[m_held[part].axis].direction, m_values[at]);
        isDetermined = isDetermined && m_determined[at] != 0;
      }
      const Vector3 torque = vectorOf(components);
      m_wrenches.addCouple(link, torque);
      m_wrenches.addCouple(against, -1.0 * torque);
      if (!isDetermined) mark(link, against);
    }
  }

  [[nodiscard]] std::vector<BearingReaction> take() {
    ByJoint<BearingReaction> bearings(static_cast<std::size_t>(m_model.t()));
    const SpanningTree& tree = m_model.tree();
    const auto order = tree.preorder();
    for (auto link = order.rbegin(); link != order.rend(); ++link) {
      if (*link == 0) continue;
      const JointOrdinal joint = tree.jointToParent(*link);
      const AxisLine& axis = m_placement.axes[m_placement.tree->axisOf[joint]];
      BearingReaction& bearing = bearings[joint];
      const double offset = m_mechanism.turningJoints[joint].offset.value();
      bearing.point = axis.point + offset * axis.direction;
      // On the child it is opposite to all that acts beyond; on the head, if that is the parent, the same.
      const double sign = tree.directionToGround(joint) > 0 ? 1 : -1;
      bearing.force = withoutRounding(sign * m_wrenches.force(*link));
      bearing.moment = withoutRounding(sign * m_wrenches.momentAbout(*link, bearing.point));
      bearing.isDetermined = m_keys[*link] == 0;
      const LinkOrdinal parent = tree.parent(*link);
      m_wrenches.pass(*link, parent);
      m_keys[parent] ^= m_keys[*link];
    }
    return bearings;
  }

 private:
  /// What acts between the two links is not determined: nor are the reactions of joints between them. The key
  /// stays in the exclusive-or of all links beyond a joint exactly if one of the two is.
  void mark(int one, int other) {
    m_next = (m_next ^ (m_next >> 27U)) * 0x94d049bb133111ebU + 0x9e3779b97f4a7c15U;
    m_keys[one] ^= m_next;
    m_keys[other] ^= m_next;
  }

  const Mechanism& m_mechanism;
  const KinematicModel& m_model;
  const Placement& m_placement;
  std::span<const HeldPart> m_held;
  std::span<const double> m_values;
  std::span<const char> m_determined;
  LinkWrenches m_wrenches;
  ByLink<std::uint64_t> m_keys;
  std::uint64_t m_next = 1;
};

/// Along which helical teeth push: the axis of the tail's gear; of a spiral bevel the line where the cones
/// touch, the way in which that gear's half axis leads along the axis.
Vector3 helixLine(const Placement& placement, const MeshGeometry& mesh) {
  const Vector3& tail = placement.lineOfClass(mesh.tailClass).direction;
  if (!hasIntersectingAxes(mesh.kind)) return tail;
  const Vector3& head = placement.lineOfClass(mesh.headClass).direction;
  const Vector3 apex = apexOf<double>({{0, 0, 0}, tail, mesh.tailToHead, head, 1, 1});
  return static_cast<double>(tailHalfAxis(mesh, tail, head)) * unit(mesh.tailToPitch - apex);
}

}  // namespace

Vector3 vectorOf(const std::vector<std::pair<Vector3, double>>& components) {
  Vector3 sum{0, 0, 0};
  std::vector<Vector3> basis;
  for (const auto& [direction, value] : components) {
    Vector3 rest = direction;
    for (const Vector3& known : basis) rest = rest - dot(rest, known) * known;
    const double left = length(rest);
    if (left < 1e-9) continue;
    const Vector3 across = (1 / left) * rest;
    sum = sum + ((value - dot(sum, direction)) / left) * across;
    basis.push_back(across);
  }
  return sum;
}

std::vector<ToothForce> toothForces(const Mechanism& mechanism, const KinematicModel& model,
                                    const Placement& placement, std::span<const double> values,
                                    std::span<const char> determined, std::span<const double> pressureAngles,
                                    std::span<const double> helixAngles) {
  std::vector<ToothForce> forces;
  const auto metres = metresPerUnit(mechanism);
  if (!metres) return forces;
  for (MeshOrdinal mesh = 0; mesh < model.c(); ++mesh) {
    const auto at = static_cast<std::size_t>(mesh);
    const MeshGeometry& geometry = *placement.meshes[at];
    ToothForce& force = forces.emplace_back();
    force.tangential = values[at] * geometry.tailTeeth / (geometry.tailRadius * metres->toDouble());
    force.isDetermined = determined[at] != 0;
    force.point = geometry.pitchPoint;
    if (!touches(geometry.kind)) {
      pullAlongStrand(placement, geometry, force);
      continue;
    }
    if (pairKind(geometry.kind).isOffset) {
      pushCones(placement, geometry, pressureAngles[at], force);
      continue;
    }
    if (hasSkewAxes(geometry.kind)) {
      pushAcross(placement, geometry, pressureAngles[at], force);
      continue;
    }
    force.separating = std::abs(force.tangential) * std::tan(pressureAngles[at]);
    const bool headIsSmaller = std::abs(geometry.headRadius) < std::abs(geometry.tailRadius);
    force.direction = (headIsSmaller ? 1.0 : -1.0) * towardsSmaller(placement, geometry);
    force.force = force.tangential * geometry.normal + force.separating * force.direction;
    if (!helixAngles.empty() && helixAngles[at] != 0) {
      const double along = -force.tangential * (geometry.tailRadius < 0 ? -1 : 1) * std::tan(helixAngles[at]);
      const Vector3 axis = helixLine(placement, geometry);
      force.axial = std::abs(along);
      force.axialDirection = (along < 0 ? -1.0 : 1.0) * axis;
      force.force = force.force + along * axis;
    }
  }
  return forces;
}

StaticsForces forcesOf(const Mechanism& mechanism, const KinematicModel& model, const Placement& placement,
                       const StaticsProblem& problem, std::span<const HeldPart> held,
                       std::span<const double> values, std::span<const char> determined,
                       std::span<const MeshLoss> losses, std::span<const double> pressureAngles,
                       std::span<const double> helixAngles) {
  StaticsForces result;
  const auto metres = metresPerUnit(mechanism);
  if (!metres) return result;
  result.meshes = toothForces(mechanism, model, placement, values, determined, pressureAngles, helixAngles);
  ForceSum sum(mechanism, model, placement, metres->toDouble(), held, values, determined);
  sum.addMeshes(result.meshes, losses);
  sum.addLoads(problem);
  sum.addHeld(problem);
  result.bearings = sum.take();
  return result;
}

}  // namespace geargraph
