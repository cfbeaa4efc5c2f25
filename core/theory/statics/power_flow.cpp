#include "core/theory/statics/power_flow.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "core/foundations/base/contract.h"
#include "core/foundations/base/position_index.h"
#include "core/theory/states/relative_speed.h"
#include "core/theory/statics/forces.h"

namespace geargraph {
namespace {

/// A vector as a sum over the directions of a train, by ascending direction.
template <class Value>
using Components = std::vector<std::pair<int, Value>>;

template <class Value>
void addTo(Components<Value>& sum, int direction, const Value& value) {
  const auto at = std::lower_bound(sum.begin(), sum.end(), direction,
                                   [](const auto& one, int other) { return one.first < other; });
  if (at != sum.end() && at->first == direction) {
    at->second += value;
  } else {
    sum.insert(at, {direction, value});
  }
}

/// The directions of the axes of a train: parallel ones are one, as in the kinematics.
class Directions {
 public:
  Directions(const Mechanism& mechanism, const Placement& placement) {
    const int classes = static_cast<int>(placement.classes->classes.size());
    for (AxisGroupOrdinal axisGroup = 0; axisGroup < classes; ++axisGroup) {
      std::pair<int, int> known{-1, 1};
      for (std::size_t at = 0; at < m_classOf.size() && known.first < 0; ++at)
        if (const int sign = directionSign(placement, axisGroup, m_classOf[at]); sign != 0)
          known = {static_cast<int>(at), sign};
      if (known.first < 0) {
        known.first = static_cast<int>(m_vectors.size());
        m_classOf.push_back(axisGroup);
        m_vectors.push_back(exactLineOfClass(mechanism, placement, axisGroup).direction);
      }
      m_ofClass.push_back(known);
    }
  }

  /// The direction of a class's line, and the sign.
  [[nodiscard]] std::pair<int, int> ofClass(AxisGroupOrdinal axisGroup) const { return m_ofClass[axisGroup]; }
  /// Of the classes' lines, all.
  [[nodiscard]] bool areParallel() const { return m_classOf.size() == 1; }
  /// Any other, one that is known where it is parallel to it in fractions.
  int of(const ExactVector3& vector) {
    for (std::size_t at = 0; at < m_vectors.size(); ++at) {
      const ExactVector3 product = cross(m_vectors[at], vector);
      if (dot(product, product).isZero() && dot(m_vectors[at], vector).sign() > 0)
        return static_cast<int>(at);
    }
    m_vectors.push_back(vector);
    return static_cast<int>(m_vectors.size()) - 1;
  }

  template <class One, class Other>
  [[nodiscard]] Real product(const Components<One>& one, const Components<Other>& other) {
    Real sum;
    for (const auto& [first, a] : one)
      for (const auto& [second, b] : other) sum += Real(a) * Real(b) * cosine(first, second);
    return sum;
  }

 private:
  const Real& cosine(int one, int other) {
    if (one == other) return m_one;
    const auto [at, isNew] = m_cosines.try_emplace(std::minmax(one, other));
    if (isNew)
      at->second =
          cosineBetween(m_vectors[static_cast<std::size_t>(one)], m_vectors[static_cast<std::size_t>(other)]);
    return at->second;
  }

  std::vector<int> m_classOf;  ///< by direction of classes, the first class that has it
  std::vector<ExactVector3> m_vectors;
  ByClass<std::pair<int, int>> m_ofClass;
  std::map<std::pair<int, int>, Real> m_cosines;
  Real m_one = 1;
};

class Flow {
 public:
  Flow(const Mechanism& mechanism, const KinematicModel& model, const Placement& placement,
       const StaticsProblem& problem, const StaticsSolution& solution, std::span<const MeshLoss> losses,
       const Motion& motion, LinkOrdinal observer)
      : m_mechanism(mechanism),
        m_model(model),
        m_placement(placement),
        m_problem(problem),
        m_solution(solution),
        m_losses(losses),
        m_motion(motion),
        m_directions(mechanism, placement),
        m_couples(static_cast<std::size_t>(model.n()) + 1),
        m_fed(static_cast<std::size_t>(model.t())),
        m_throughForces(static_cast<std::size_t>(model.n()) + 1),
        m_isAssumed(static_cast<std::size_t>(model.c()) + solution.held.size()) {
    m_flow.observer = observer;
    for (const SelfStress& stress : solution.selfStresses) {
      if (!isDecided(stress)) continue;
      for (const auto& [unknown, weight] : stress) m_isAssumed[static_cast<std::size_t>(unknown)] = 1;
    }
    takeSpeeds();
  }

  PowerFlow run() {
    for (MeshOrdinal mesh = 0; mesh < m_model.c(); ++mesh) addMesh(mesh);
    const std::size_t meshes = m_flow.elements.size();
    addCouplings();
    addLoads();
    addBalances();
    addJoints(meshes);
    return std::move(m_flow);
  }

 private:
  using Torque = Components<Real>;
  using SelfStress = std::vector<std::pair<int, Rational>>;

  [[nodiscard]] const Real& value(int unknown) const {
    return m_solution.values[static_cast<std::size_t>(unknown)];
  }

  /// The angular velocities of all links against the observer.
  void takeSpeeds() {
    const SpanningTree& tree = m_model.tree();
    m_speeds.resize(static_cast<std::size_t>(m_model.n()) + 1);
    for (const LinkOrdinal link : tree.preorder()) {
      if (link == 0) continue;
      const auto joint = static_cast<std::size_t>(tree.jointToParent(link));
      auto& speed = m_speeds[link];
      speed = m_speeds[tree.parent(link)];
      const auto [direction, sign] = m_directions.ofClass(m_placement.classes->classOf[joint]);
      const int along = sign * m_placement.classes->orientationSign[joint] *
                        -tree.directionToGround(static_cast<int>(joint));
      addTo(speed, direction, Rational(along) * m_motion[joint]);
    }
    const auto observer = m_speeds[m_flow.observer];
    for (auto& speed : m_speeds)
      for (const auto& [direction, part] : observer) addTo(speed, direction, -part);
  }

  [[nodiscard]] Real power(const Torque& torque, LinkOrdinal link) {
    return m_directions.product(torque, m_speeds[link]);
  }
  [[nodiscard]] static Torque opposite(Torque torque) {
    for (auto& [direction, part] : torque) part = -part;
    return torque;
  }

  /// A port of the element, whose torque also becomes part of what the joints before the link pass.
  void act(ElementPower& element, LinkOrdinal link, const Torque& torque) {
    element.ports.push_back({link, power(torque, link)});
    auto& sum = m_couples[link];
    for (const auto& [direction, part] : torque) addTo(sum, direction, part);
  }

  ElementPower& add(ElementPower::Kind kind, int position) {
    ElementPower& element = m_flow.elements.emplace_back();
    element.kind = kind;
    element.position = position;
    return element;
  }

  void addMesh(MeshOrdinal mesh) {
    const MeshGeometry& geometry = *m_placement.meshes[mesh];
    const PortTorques ports = portTorques(m_model, m_solution, m_losses, mesh);
    const auto along = [&](AxisGroupOrdinal axisGroup, const Real& size) {
      const auto [direction, sign] = m_directions.ofClass(axisGroup);
      return Torque{{direction, Real(sign) * size}};
    };
    const Torque onTail = along(geometry.tailClass, ports.tail);
    const Torque onHead = along(geometry.headClass, ports.head);
    Torque onCarrier = opposite(onTail);
    for (const auto& [direction, part] : onHead) addTo(onCarrier, direction, -part);
    ElementPower& element = add(ElementPower::Kind::mesh, mesh);
    act(element, geometry.tail, onTail);
    act(element, geometry.head, onHead);
    act(element, geometry.carrier, onCarrier);
    element.isDetermined = m_solution.isDetermined(mesh);
    element.isAssumed = isAssumed(mesh);
  }

  /// Is the unknown part of a self-stress whose share was decided, by stiffness?
  [[nodiscard]] bool isAssumed(int unknown) const {
    return m_isAssumed[static_cast<std::size_t>(unknown)] != 0;
  }

  void addCouplings() {
    const PositionIndex<LinkTag> links(m_mechanism.links);
    const std::vector<HeldPart>& held = m_solution.held;
    for (std::size_t part = 0; part < held.size() && held[part].coupling >= 0;) {
      const int position = held[part].coupling;
      const ShiftElement& coupling = m_mechanism.couplings[position];
      const LinkOrdinal link = links.at(coupling.links.front());
      const int against = coupling.kind == ShiftElementKind::brake ? 0 : links.at(coupling.links.back());
      const std::size_t first = part;
      bool isDetermined = true;
      bool isByStiffness = false;
      for (; part < held.size() && held[part].coupling == position; ++part) {
        const int unknown = m_model.c() + static_cast<int>(part);
        isDetermined = isDetermined && m_solution.isDetermined(unknown);
        isByStiffness = isByStiffness || isAssumed(unknown);
      }
      const Torque torque = torqueOf(first, part);
      ElementPower& element = add(ElementPower::Kind::coupling, position);
      act(element, link, torque);
      act(element, against, opposite(torque));
      element.isDetermined = isDetermined;
      element.isAssumed = isByStiffness;
    }
  }

  /// The torque of a coupling from its held parts: along one direction as it is, else from its components.
  Torque torqueOf(std::size_t first, std::size_t last) {
    const auto unknown = [&](std::size_t part) { return value(m_model.c() + static_cast<int>(part)); };
    const auto axis = [&](std::size_t part) { return m_solution.held[part].axis; };
    if (last == first + 1) {
      const auto joint = firstJointOn(axis(first));
      const auto [direction, sign] = m_directions.ofClass(m_placement.classes->classOf[joint]);
      return {{direction, Real(sign * m_placement.classes->orientationSign[joint]) * unknown(first)}};
    }
    std::vector<std::pair<Vector3, double>> components;
    for (std::size_t part = first; part < last; ++part)
      components.emplace_back(m_placement.axes[axis(part)].direction, unknown(part).number());
    const Vector3 vector = vectorOf(components);
    Torque torque;
    for (std::size_t i = 0; i < 3; ++i) {
      ExactVector3 base{};
      base[i] = Rational(1);
      addTo(torque, m_directions.of(base), Real::inexact(vector[i]));
    }
    return torque;
  }
  [[nodiscard]] std::size_t firstJointOn(AxisOrdinal axis) const {
    const std::span<const int> axes = m_placement.tree->axisOf;
    return static_cast<std::size_t>(std::find(axes.begin(), axes.end(), axis) - axes.begin());
  }

  void addLoads() {
    int position = 0;
    for (const AppliedTorque& load : m_problem.torques) {
      const int own = position++;
      if (load.place.inJoint()) {
        const auto joint = static_cast<std::size_t>(load.place.joint);
        m_fed[joint] += Real(load.torque) * Real(m_motion[joint]);
        continue;
      }
      addOnLink(ElementPower::Kind::load, own, load.place, Real(load.torque));
    }
    if (!metresPerUnit(m_mechanism)) return;  // then forces are no part of the equilibrium
    for (const AppliedForce& load : m_problem.forces) addForce(position++, load);
  }

  void addBalances() {
    for (std::size_t part = 0; part < m_solution.held.size(); ++part) {
      const int balance = m_solution.held[part].balance;
      if (balance < 0) continue;
      const TorquePlace& place = m_problem.balances[static_cast<std::size_t>(balance)];
      const int unknown = m_model.c() + static_cast<int>(part);
      if (place.inJoint()) {
        const auto joint = static_cast<std::size_t>(place.joint);
        m_fed[joint] += value(unknown) * Real(m_motion[joint]);
        if (!m_solution.isDetermined(unknown)) m_openJoints.push_back(place.joint);
        if (isAssumed(unknown)) m_assumedJoints.push_back(place.joint);
        continue;
      }
      addOnLink(ElementPower::Kind::balance, balance, place, value(unknown));
      m_flow.elements.back().isDetermined = m_solution.isDetermined(unknown);
      m_flow.elements.back().isAssumed = isAssumed(unknown);
    }
  }

  void addOnLink(ElementPower::Kind kind, int position, const TorquePlace& place, const Real& size) {
    Torque torque{{m_directions.of(place.direction), size}};
    ElementPower& element = add(kind, position);
    act(element, place.link, torque);
    act(element, 0, opposite(std::move(torque)));
  }

  /// By the same force on the links before it: the sum over the joints from each to the ground.
  void addForce(int position, const AppliedForce& load) {
    const auto powerOn = [&](LinkOrdinal link) {
      if (link == 0) return Real();
      StaticsProblem only;
      only.forces = {{link, load.force, load.point}};
      return powerOf(m_model, LoadPower::of(m_mechanism, m_model, m_placement, only).byLink, m_motion);
    };
    const Real onObserver = powerOn(m_flow.observer);
    const SpanningTree& tree = m_model.tree();
    ElementPower& element = add(ElementPower::Kind::load, position);
    element.ports.push_back({load.link, powerOn(load.link) - onObserver});
    element.ports.push_back({0, onObserver});
    StaticsProblem only;
    only.forces = {load};
    const LoadPower shared = LoadPower::of(m_mechanism, m_model, m_placement, only);
    // What the force would do on each link before its own, from the ground up.
    std::vector<int> path;
    for (LinkOrdinal link = load.link; link != 0; link = tree.parent(link)) path.push_back(link);
    Real onParent = -onObserver;
    for (auto link = path.rbegin(); link != path.rend(); ++link) {
      m_throughForces[*link] += onParent;
      const JointOrdinal joint = tree.jointToParent(*link);
      onParent += shared.byJoint.at(joint) * Real(m_motion[static_cast<std::size_t>(joint)]);
    }
  }

  /// From the leaves towards the ground: each joint passes what acts beyond it, times its parent's twist.
  void addJoints(std::size_t place) {
    ByJoint<ElementPower> joints(static_cast<std::size_t>(m_model.t()));
    const SpanningTree& tree = m_model.tree();
    const auto order = tree.preorder();
    for (auto link = order.rbegin(); link != order.rend(); ++link) {
      if (*link == 0) continue;
      const auto at = static_cast<std::size_t>(*link);
      const JointOrdinal joint = tree.jointToParent(*link);
      const LinkOrdinal parent = tree.parent(*link);
      const Real toParent = power(m_couples[at], parent) + m_throughForces[at];
      const Real toChild = m_fed[joint] - toParent;
      ElementPower& element = joints[joint];
      element.kind = ElementPower::Kind::joint;
      element.position = joint;
      element.ports = {{parent, toParent}, {*link, toChild}};
      if (m_model.graph().turningEdge(joint).tail == *link) std::swap(element.ports[0], element.ports[1]);
      for (const auto& [direction, part] : m_couples[at]) addTo(m_couples[parent], direction, part);
      m_couples[at] = {};
    }
    for (const JointOrdinal joint : m_openJoints) joints[joint].isDetermined = false;
    for (const JointOrdinal joint : m_assumedJoints) joints[joint].isAssumed = true;
    for (const auto& stress : m_solution.selfStresses) markJointsOf(stress, isDecided(stress), joints);
    m_flow.elements.insert(m_flow.elements.begin() + static_cast<std::ptrdiff_t>(place),
                           std::make_move_iterator(joints.begin()), std::make_move_iterator(joints.end()));
  }

  /// Was the share decided, by stiffness?
  [[nodiscard]] bool isDecided(const SelfStress& stress) const {
    return std::all_of(stress.begin(), stress.end(),
                       [&](const auto& member) { return m_solution.isDetermined(member.first); });
  }

  /// Marks the joints whose power a self-stress changes, as assumed where its share is decided, else as not
  /// determined: not those between its links where its torques cancel, or do no work. Between parallel axes
  /// joints pass nothing of it. Cost: O(members * depth).
  void markJointsOf(const SelfStress& stress, bool isKnown, std::vector<ElementPower>& joints) {
    if (m_directions.areParallel()) return;
    const SpanningTree& tree = m_model.tree();
    // By depth and link, the deepest first: what acts on a link and beyond.
    std::map<std::pair<int, int>, Torque, std::greater<>> waiting;
    const auto put = [&](LinkOrdinal link, const Torque& torque) {
      for (const auto& [direction, part] : torque)
        if (link != 0) addTo(waiting[{tree.depth(link), link}], direction, part);
    };
    for (const auto& [unknown, weight] : stress) actOn(unknown, weight, put);
    while (!waiting.empty()) {
      const auto [key, torque] = *waiting.begin();
      waiting.erase(waiting.begin());
      const LinkOrdinal link = key.second;
      const LinkOrdinal parent = tree.parent(link);
      if (isFelt(torque, parent)) {
        ElementPower& joint = joints[static_cast<std::size_t>(tree.jointToParent(link))];
        if (isKnown) joint.isAssumed = true;
        if (!isKnown) joint.isDetermined = false;
      }
      put(parent, torque);
    }
  }

  /// The torques of one member of a self-stress on the links, by put(link, torque).
  template <class Put>
  void actOn(int unknown, const Rational& weight, const Put& put) {
    if (unknown < m_model.c()) {
      const MeshGeometry& geometry = *m_placement.meshes[unknown];
      const KinematicModel::MeshRow& row = m_model.meshRow(unknown);
      const auto add = [&](LinkOrdinal gear, AxisGroupOrdinal axisGroup, const Rational& size) {
        const auto [direction, sign] = m_directions.ofClass(axisGroup);
        const Torque torque{{direction, Real(Rational(sign) * size)}};
        put(gear, torque);
        put(geometry.carrier, opposite(torque));
      };
      add(geometry.tail, geometry.tailClass, Rational(-row.tailTeeth) * weight);
      add(geometry.head, geometry.headClass, Rational(row.sign * row.headTeeth) * weight);
      return;
    }
    const HeldPart& part = m_solution.held[static_cast<std::size_t>(unknown - m_model.c())];
    if (part.balance >= 0) {
      const TorquePlace& place = m_problem.balances[static_cast<std::size_t>(part.balance)];
      if (!place.inJoint()) put(place.link, {{m_directions.of(place.direction), Real(weight)}});
      return;
    }
    const ShiftElement& coupling = m_mechanism.couplings[part.coupling];
    const auto joint = firstJointOn(part.axis);
    const auto [direction, sign] = m_directions.ofClass(m_placement.classes->classOf[joint]);
    const Torque torque{
        {direction, Real(Rational(sign * m_placement.classes->orientationSign[joint]) * weight)}};
    const PositionIndex<LinkTag> links(m_mechanism.links);
    put(links.at(coupling.links.front()), torque);
    if (coupling.kind != ShiftElementKind::brake) put(links.at(coupling.links.back()), opposite(torque));
  }

  /// Does the torque do work on the link? What is rounded counts beyond rounding only.
  [[nodiscard]] bool isFelt(const Torque& torque, LinkOrdinal link) {
    const Real felt = power(torque, link);
    if (felt.isExact()) return !felt.isZero();
    constexpr double kRounding = 1e-9;
    double torques = 0;
    double speeds = 0;
    for (const auto& [direction, part] : torque) torques += std::abs(part.number());
    for (const auto& [direction, part] : m_speeds[link]) speeds += std::abs(part.toDouble());
    return std::abs(felt.number()) > kRounding * torques * speeds;
  }

  const Mechanism& m_mechanism;
  const KinematicModel& m_model;
  const Placement& m_placement;
  const StaticsProblem& m_problem;
  const StaticsSolution& m_solution;
  std::span<const MeshLoss> m_losses;
  const Motion& m_motion;
  Directions m_directions;
  ByLink<Components<Rational>> m_speeds;  ///< against the observer
  ByLink<Torque> m_couples;               ///< the sum of those on it and beyond
  ByJoint<Real> m_fed;                    ///< by the loads and balances in it
  ByLink<Real> m_throughForces;           ///< what forces beyond would do on its parent
  std::vector<char> m_isAssumed;          ///< by unknown
  std::vector<int> m_openJoints;
  std::vector<int> m_assumedJoints;
  PowerFlow m_flow;
};

}  // namespace

Real ElementPower::fed() const {
  Real sum;
  for (const PowerPort& port : ports) sum += port.power;
  return sum;
}

ByLink<Real> PowerFlow::sums(int links) const {
  ByLink<Real> sums(static_cast<std::size_t>(links));
  for (const ElementPower& element : elements)
    for (const PowerPort& port : element.ports) sums[port.link] += port.power;
  return sums;
}

const ElementPower& PowerFlow::of(ElementPower::Kind kind, int position) const {
  const auto found = std::lower_bound(elements.begin(), elements.end(), std::pair(kind, position),
                                      [](const ElementPower& each, const auto& asked) {
                                        return std::pair(each.kind, each.position) < asked;
                                      });
  GEARGRAPH_REQUIRE(found != elements.end() && found->kind == kind && found->position == position);
  return *found;
}

PowerFlow powerFlow(const Mechanism& mechanism, const KinematicModel& model, const Placement& placement,
                    const StaticsProblem& problem, const StaticsSolution& solution,
                    std::span<const MeshLoss> losses, const Motion& motion, LinkOrdinal observer) {
  return Flow(mechanism, model, placement, problem, solution, losses, motion, observer).run();
}

std::optional<Real> latentRatio(const StaticsSolution& solution, const MeshPowers& powers, const Real& fed) {
  if (fed.isZero()) return std::nullopt;
  Real sum;
  for (std::size_t mesh = 0; mesh < powers.mesh.size(); ++mesh) {
    if (!solution.isDetermined(static_cast<int>(mesh))) return std::nullopt;
    sum += powers.mesh[mesh].abs();
  }
  return sum / fed;
}

}  // namespace geargraph
