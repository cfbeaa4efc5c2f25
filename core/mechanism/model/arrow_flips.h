#pragma once

#include <utility>
#include <variant>

#include "core/mechanism/model/mechanism.h"

namespace geargraph {

/// Exchanges tail and head; the limits are reversed accordingly.
inline void flip(TurningJoint& joint) {
  std::swap(joint.tail, joint.head);
  joint.limits = opposite(joint.limits);
}
/// Exchanges tail and head with their teeth and wheels. The helix, which is that of the tail's gear, becomes
/// that of the other one: of the opposite hand, if the pair is not (said to be) an internal one; of axes that
/// cross (at right angles) the rest to 90 degrees, of the same hand. That of a rack is its pinion's and
/// stays.
inline void flip(GearMesh& mesh) {
  std::swap(mesh.tail, mesh.head);
  std::swap(mesh.tailTeeth, mesh.headTeeth);
  std::swap(mesh.tailWheel, mesh.headWheel);
  if (!mesh.helixAngle || turnsAlike(saidKind(mesh)) || slides(saidKind(mesh))) return;
  if (hasSkewAxes(saidKind(mesh))) {
    mesh.helixAngle = Number(Rational(90) - mesh.helixAngle->exact());
    return;
  }
  mesh.hand = mesh.hand == Hand::left ? Hand::right : Hand::left;
}

/// Adapts a torque in the joint after a flip of the joint: the same action on the same two links.
inline void flipOnJoint(Load& load, const JointId& joint) {
  auto* torque = std::get_if<JointTorque>(&load.action);
  if (torque != nullptr && torque->joint == joint) torque->torque = Number(-torque->torque.exact());
}

}  // namespace geargraph
