#pragma once

#include <utility>
#include <vector>

#include "tests/core/support/trains.h"

namespace geargraph::test {

/// The paper's robot with its arrows the other way where the paper draws none that way: every mesh from its
/// head to its tail, so that carriers are met on the head's side; joint 12 towards link 1; joint 9 on an axis
/// of its own on the line of b, pointing against it. No mesh says its kind.
[[nodiscard]] inline Mechanism robotAgainstItsArrows() {
  Mechanism mechanism = robot();
  for (GearMesh& mesh : mechanism.gearMeshes) {
    std::swap(mesh.tail, mesh.head);
    std::swap(mesh.tailTeeth, mesh.headTeeth);
    std::swap(mesh.tailWheel, mesh.headWheel);
    mesh.kind.reset();  // the pitch point says it
  }
  std::swap(mechanism.turningJoints[4].tail, mechanism.turningJoints[4].head);
  Axis against = *mechanism.find(mechanism.turningJoints[1].axis);
  against.id = AxisId("against b");
  for (Number& component : *against.direction) component = Number(-component.exact());
  mechanism.turningJoints[1].axis = against.id;
  mechanism.axes.push_back(against);
  return mechanism;
}

/// Eq. (25) for it, at the teeth 18/36, 20/30, 24/18, 16/24: the column of 9 and the row of 12 change sign.
[[nodiscard]] inline std::vector<Rational> solutionAgainstItsArrows() {
  return {{-1, 2},  0,        0,         // 10
          {1, 3},   {-2, 3},  0,         // 12
          {-4, 9},  {8, 9},   {-4, 3},   // 13
          {-8, 27}, {16, 27}, {-8, 9}};  // 14
}

}  // namespace geargraph::test
