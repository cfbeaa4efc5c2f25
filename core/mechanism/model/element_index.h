#pragma once

#include <optional>
#include <string>

#include "core/foundations/base/position_index.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph {

/// The elements of one mechanism by id, for callers that look up many of them: Mechanism::find and labelOf()
/// search a list each time, so looking up all elements that way is quadratic in the size of the document.
///
/// Cost: O(n + t + c) to build, O(1) per look-up (a state, a load or a note: O(its list)).
class ElementIndex {
 public:
  explicit ElementIndex(MechanismPtr mechanism);

  [[nodiscard]] bool contains(const ElementId& element) const;
  /// Null where the mechanism has no such element.
  [[nodiscard]] const Link* find(LinkId id) const;
  [[nodiscard]] const Axis* find(AxisId id) const;
  [[nodiscard]] const TurningJoint* find(JointId id) const;
  [[nodiscard]] const GearMesh* find(MeshId id) const;
  /// As labelOf(), but std::nullopt also for an axis, a wheel or a coupling that is not in the mechanism.
  [[nodiscard]] std::optional<std::string> labelOf(const ElementId& element) const;

 private:
  MechanismPtr m_mechanism;
  PositionIndex<LinkTag> m_links;
  PositionIndex<AxisTag> m_axes;
  PositionIndex<JointTag> m_joints;
  PositionIndex<MeshTag> m_meshes;
  PositionIndex<WheelTag> m_wheels;
  PositionIndex<CouplingTag> m_couplings;
};

}  // namespace geargraph
