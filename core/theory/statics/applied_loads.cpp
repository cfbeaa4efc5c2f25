#include "core/theory/statics/applied_loads.h"

#include <cmath>

#include "core/foundations/base/position_index.h"
#include "core/mechanism/model/length.h"

namespace geargraph {
namespace {

/// Adds the power of one load for unit speeds of links and joints, from the link towards the ground.
class PowerSum {
 public:
  PowerSum(const Mechanism& mechanism, const KinematicModel& model, const Placement& placement,
           const Rational& metres, LoadPower& power)
      : m_mechanism(mechanism), m_model(model), m_placement(placement), m_metres(metres), m_power(power) {}

  void addInJoint(JointOrdinal joint, const Rational& torque) {
    const KinematicModel::JointRate& rate = m_model.jointRate(joint);
    m_power.byLink.add(rate.child, Rational(rate.sign) * torque);
    if (rate.parent != 0) m_power.byLink.add(rate.parent, Rational(-rate.sign) * torque);
    m_power.byJoint.add(joint, torque);
  }

  /// A torque about a direction that is not of length 1: the whole is divided by its length.
  void addTorque(LinkOrdinal link, const ExactVector3& direction, const Rational& torque) {
    const Rational square = dot(direction, direction).inverse();
    addAlongPath(link, square,
                 [&](const ExactLine& line) { return torque * dot(line.direction, direction); });
  }

  void addForce(const AppliedForce& load) {
    addAlongPath(load.link, 1, [&](const ExactLine& line) {
      return m_metres * dot(line.direction, cross(load.point - line.point, load.force));
    });
  }

 private:
  /// `component(line)`: the load's moment about a line whose direction counts with its length.
  template <class Component>
  void addAlongPath(LinkOrdinal link, const Rational& square, const Component& component) {
    const auto add = [&](RadicalColumns& to, int place, int sign, const ExactLine& line) {
      to.add(place, Rational(sign) * component(line), square * dot(line.direction, line.direction).inverse());
    };
    const AxisGroups& classes = *m_placement.classes;
    for (int at = link; at != 0;) {
      const AxisGroupOrdinal axisGroup = classes.classOfLink(at);
      add(m_power.byLink, at, 1, exactLineOfClass(m_mechanism, m_placement, axisGroup));
      at = classes.classes[axisGroup].rootLink;
    }
    const SpanningTree& tree = m_model.tree();
    for (int at = link; at != 0; at = tree.parent(at)) {
      const JointOrdinal joint = tree.jointToParent(at);
      const AxisOrdinal axis = m_placement.tree->axisOf[joint];
      add(m_power.byJoint, joint, -tree.directionToGround(joint), exactLine(m_mechanism, m_placement, axis));
    }
  }

  const Mechanism& m_mechanism;
  const KinematicModel& m_model;
  const Placement& m_placement;
  Rational m_metres;
  LoadPower& m_power;
};

}  // namespace

TorquePlace onLink(const Mechanism& mechanism, const Placement& placement, LinkOrdinal link,
                   std::optional<AxisId> axis) {
  TorquePlace place;
  place.link = link;
  const JointTree& tree = *placement.tree;
  place.axis = axis ? PositionIndex<AxisTag>(mechanism.axes).at(*axis) : tree.axisOf[tree.joint[link]];
  place.direction = exactLine(mechanism, placement, place.axis).direction;
  return place;
}

void addLoads(const Mechanism& mechanism, const Placement& placement, std::span<const Load> loads,
              StaticsProblem& problem) {
  if (loads.empty()) return;
  const PositionIndex<LinkTag> links(mechanism.links);
  const PositionIndex<JointTag> joints(mechanism.turningJoints);
  for (const Load& load : loads) {
    if (const auto* inJoint = std::get_if<JointTorque>(&load.action)) {
      problem.torques.push_back({TorquePlace{joints.at(inJoint->joint)}, inJoint->torque.exact()});
    } else if (const auto* torque = std::get_if<LinkTorque>(&load.action)) {
      problem.torques.push_back(
          {onLink(mechanism, placement, links.at(torque->link), torque->axis), torque->torque.exact()});
    } else {
      const auto& force = std::get<LinkForce>(load.action);
      problem.forces.push_back({links.at(force.link), toFractions(force.force), toFractions(force.point)});
    }
  }
}

std::vector<TorquePlace> placesOf(const Mechanism& mechanism, const Placement& placement,
                                  std::span<const HoldingTorque> balances) {
  const PositionIndex<LinkTag> links(mechanism.links);
  const PositionIndex<JointTag> joints(mechanism.turningJoints);
  std::vector<TorquePlace> places;
  for (const HoldingTorque& balance : balances) {
    if (const auto* joint = std::get_if<JointId>(&balance.at)) {
      places.push_back(TorquePlace{joints.at(*joint)});
    } else {
      const auto& on = std::get<HoldingTorque::OnLink>(balance.at);
      places.push_back(onLink(mechanism, placement, links.at(on.link), on.axis));
    }
  }
  return places;
}

std::optional<Rational> metresPerUnit(const Mechanism& mechanism) {
  if (mechanism.unit.empty()) return std::nullopt;  // "1 " alone would be read as metres
  const auto length = lengthFromText("1 " + mechanism.unit, "m");
  return length ? std::optional(length->exact()) : std::nullopt;
}

LoadPower LoadPower::of(const Mechanism& mechanism, const KinematicModel& model, const Placement& placement,
                        const StaticsProblem& problem) {
  LoadPower power;
  const auto metres = metresPerUnit(mechanism);
  PowerSum sum(mechanism, model, placement, metres.value_or(1), power);
  for (const AppliedTorque& load : problem.torques) {
    if (load.place.inJoint()) {
      sum.addInJoint(load.place.joint, load.torque);
    } else {
      sum.addTorque(load.place.link, load.place.direction, load.torque);
    }
  }
  if (!metres) return power;
  for (const AppliedForce& load : problem.forces) sum.addForce(load);
  return power;
}

Real cosineBetween(const ExactVector3& a, const ExactVector3& b) {
  const Rational product = dot(a, b);
  if (product.isZero()) return {};
  const Rational square = product * product / (dot(a, a) * dot(b, b));
  const auto root = square.squareRoot();
  if (root) return product.sign() < 0 ? -*root : *root;
  return Real::inexact(std::sqrt(square.toDouble()) * product.sign());
}

}  // namespace geargraph
