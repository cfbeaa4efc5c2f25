#pragma once

#include <utility>
#include <variant>

#include "core/mechanism/model/mechanism.h"

namespace geargraph::inline model {

/// Tail and head exchanged; the limits go with them.
inline void flip(TurningJoint& joint) {
  std::swap(joint.tail, joint.head);
  joint.limits = opposite(joint.limits);
}
/// The teeth and the wheels go with them.
inline void flip(GearMesh& mesh) {
  std::swap(mesh.tail, mesh.head);
  std::swap(mesh.tailTeeth, mesh.headTeeth);
  std::swap(mesh.tailWheel, mesh.headWheel);
}

/// A torque on the joint, after the joint is flipped: the same action on the same two links.
inline void flipOnJoint(Load& load, const JointId& joint) {
  auto* torque = std::get_if<JointTorque>(&load.action);
  if (torque != nullptr && torque->joint == joint) torque->torque = Number(-torque->torque.exact());
}

}  // namespace geargraph::inline model
