#pragma once

#include <QString>
#include <optional>
#include <set>
#include <vector>

#include "core/foundations/base/expected.h"
#include "core/mechanism/placement/placed_mechanism.h"

namespace geargraph {

/// The turning joint that carries a link: the one towards the ground, or the only candidate while the tree is
/// incomplete. Without one, `why` has the reason for a menu.
struct CarryingJoint {
  std::optional<JointId> joint;
  QString why;
};
[[nodiscard]] CarryingJoint carryingJoint(const Mechanism& mechanism, LinkId link);

[[nodiscard]] bool isInput(const Mechanism& mechanism, JointId joint);

/// Makes the joint an input with a speed of 1 rad/s, or removes its input.
[[nodiscard]] Expected<Mechanism> withInputToggled(const Mechanism& mechanism, JointId joint);
/// The same for several joints. Cost: O(n + t + c).
[[nodiscard]] Expected<Mechanism> withInputsToggled(const Mechanism& mechanism,
                                                    const std::set<JointId>& joints);

/// The joints of the selected elements for toggling inputs: selected joints, and those that carry selected
/// links.
/// Cost: O(n + t + c + elements).
[[nodiscard]] std::set<JointId> jointsDrivenBy(const Mechanism& mechanism,
                                               const std::set<ElementId>& elements);

/// The stated kind of a mesh, else the one from its geometry; std::nullopt if there is neither.
/// Cost: O(c).
[[nodiscard]] std::optional<MeshKind> shownKind(const PlacedMechanism& placed, MeshId mesh);

/// "link 3", "turning joint 8", "3 elements"
[[nodiscard]] QString describe(const Mechanism& mechanism, const std::set<ElementId>& elements);
/// With its links, axis and teeth: "Turning joint 12 from link 1 to link 2, axis c, driven".
[[nodiscard]] QString describeFully(const Mechanism& mechanism, const ElementId& element);

}  // namespace geargraph
