#pragma once

#include "core/foundations/base/expected.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph {

/// Makes a joint turn or slide about or along its axis. Where that changes it, its limits are taken away, as
/// angles are no lengths; its speed keeps its number, in the unit of what it does now. Rejected: an unknown
/// joint.
[[nodiscard]] Expected<Mechanism> withJointKind(Mechanism mechanism, JointId joint, JointKind kind);

}  // namespace geargraph
