#include "tests/core/support/extreme_documents.h"

#include "core/mechanism/model/limits.h"
#include "tests/core/support/example_files.h"

namespace geargraph::test {

Mechanism robotOfManyTeeth() {
  Mechanism robot = example("robot");
  for (GearMesh& mesh : robot.gearMeshes) {
    mesh.tailTeeth *= 1000;
    mesh.headTeeth *= 1000;
  }
  return robot;
}

Mechanism farOffsets(const char* name) {
  Mechanism mechanism = example(name);
  std::int64_t sign = 1;
  for (TurningJoint& joint : mechanism.turningJoints) joint.offset = Number((sign = -sign) * kLargestLength);
  return mechanism;
}

}  // namespace geargraph::test
