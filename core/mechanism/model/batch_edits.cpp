#include "core/mechanism/model/batch_edits.h"

#include <unordered_set>
#include <utility>

#include "core/mechanism/model/arrow_flips.h"
#include "core/mechanism/model/edits.h"

namespace geargraph {

Expected<Mechanism> withAllFlipped(Mechanism mechanism, std::span<const ElementId> elements) {
  const std::unordered_set<ElementId> wanted(elements.begin(), elements.end());
  std::unordered_set<ElementId> left = wanted;
  for (TurningJoint& joint : mechanism.turningJoints) {
    if (left.erase(joint.id) > 0) flip(joint);
  }
  for (GearMesh& mesh : mechanism.gearMeshes) {
    if (left.erase(mesh.id) > 0) flip(mesh);
  }
  for (Load& load : mechanism.loads) {
    const auto* torque = std::get_if<JointTorque>(&load.action);
    if (torque != nullptr && wanted.contains(torque->joint)) flipOnJoint(load, torque->joint);
  }
  if (!left.empty()) return withFlipped(std::move(mechanism), *left.begin());  // which tells what is unknown
  return mechanism;
}

}  // namespace geargraph
