#include "core/mechanism/model/slide_edits.h"

#include "core/mechanism/model/rejections.h"

namespace geargraph {

Expected<Mechanism> withJointKind(Mechanism mechanism, JointId joint, JointKind kind) {
  for (TurningJoint& each : mechanism.turningJoints) {
    if (each.id != joint) continue;
    if (each.kind != kind) each.limits = {};
    each.kind = kind;
    return mechanism;
  }
  return unknownElement(joint);
}

}  // namespace geargraph
