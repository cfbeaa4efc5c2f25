#include "core/mechanism/model/element_index.h"

#include <algorithm>
#include <utility>

namespace geargraph {
namespace {

template <class Element>
const Element* at(const std::vector<Element>& list, int position) {
  return position < 0 ? nullptr : &list[static_cast<std::size_t>(position)];
}

}  // namespace

ElementIndex::ElementIndex(MechanismPtr mechanism)
    : m_mechanism(std::move(mechanism)),
      m_links(m_mechanism->links),
      m_axes(m_mechanism->axes),
      m_joints(m_mechanism->turningJoints),
      m_meshes(m_mechanism->gearMeshes),
      m_wheels(m_mechanism->wheels),
      m_couplings(m_mechanism->couplings) {}

bool ElementIndex::contains(const ElementId& element) const {
  switch (element.kind) {
    case ElementKind::link:
      return m_links.positionOf(LinkId(element.id)) >= 0;
    case ElementKind::axis:
      return m_axes.positionOf(AxisId(element.id)) >= 0;
    case ElementKind::turningJoint:
      return m_joints.positionOf(JointId(element.id)) >= 0;
    case ElementKind::gearMesh:
      return m_meshes.positionOf(MeshId(element.id)) >= 0;
    case ElementKind::wheel:
      return m_wheels.positionOf(WheelId(element.id)) >= 0;
    case ElementKind::coupling:
      return m_couplings.positionOf(ShiftElementId(element.id)) >= 0;
    case ElementKind::state:
      return std::any_of(m_mechanism->states.begin(), m_mechanism->states.end(),
                         [&](const ShiftState& state) { return state.name == element.id.text(); });
    case ElementKind::load:
      return std::any_of(m_mechanism->loads.begin(), m_mechanism->loads.end(),
                         [&](const Load& load) { return load.id.atom() == element.id; });
    case ElementKind::note:
      return m_mechanism->find(NoteId(element.id)) != nullptr;
  }
  GEARGRAPH_REQUIRE(false);
}

const Link* ElementIndex::find(LinkId id) const {
  return at(m_mechanism->links, m_links.positionOf(id));
}
const Axis* ElementIndex::find(AxisId id) const {
  return at(m_mechanism->axes, m_axes.positionOf(id));
}
const TurningJoint* ElementIndex::find(JointId id) const {
  return at(m_mechanism->turningJoints, m_joints.positionOf(id));
}
const GearMesh* ElementIndex::find(MeshId id) const {
  return at(m_mechanism->gearMeshes, m_meshes.positionOf(id));
}

std::optional<std::string> ElementIndex::labelOf(const ElementId& element) const {
  if (!contains(element)) return std::nullopt;
  switch (element.kind) {
    case ElementKind::link:
      return std::to_string(m_mechanism->linkLabel(m_links.at(LinkId(element.id))));
    case ElementKind::turningJoint:
      return std::to_string(m_mechanism->jointLabel(m_joints.at(JointId(element.id))));
    case ElementKind::gearMesh:
      return std::to_string(m_mechanism->meshLabel(m_meshes.at(MeshId(element.id))));
    default:
      return element.id.text();
  }
}

}  // namespace geargraph
