#include "core/design/synthesis/set_sketch.h"

namespace geargraph {
namespace {

LinkId idOf(LinkOrdinal link) {
  return LinkId(std::to_string(link));
}

}  // namespace

SetSketch::SetSketch(std::string name) : m_mechanism(emptyMechanism()) {
  m_mechanism.name = std::move(name);
  m_mechanism.links.front().id = idOf(0);
  m_mechanism.view.nodes.clear();
}

LinkOrdinal SetSketch::link(LinkOrdinal parent, const std::string& axis, std::string name) {
  const int number = static_cast<int>(m_mechanism.links.size());
  const AxisId id(axis);
  if (m_mechanism.find(id) == nullptr) m_mechanism.axes.push_back({id, {}, {}});
  m_mechanism.links.push_back({idOf(number), std::move(name), {}});
  m_mechanism.turningJoints.push_back(
      {JointId("j" + std::to_string(number)), idOf(parent), idOf(number), id, Number(0), {}});
  m_parents.push_back(parent);
  return number;
}

LinkOrdinal SetSketch::slidingLink(LinkOrdinal parent, const std::string& axis, std::string name) {
  const LinkOrdinal number = link(parent, axis, std::move(name));
  m_mechanism.turningJoints.back().kind = JointKind::sliding;
  return number;
}

void SetSketch::bearing(LinkOrdinal link, std::int64_t offset) {
  m_mechanism.turningJoints[link - 1].offset = Number(offset);
}

void SetSketch::axis(const std::string& id, const NumberTriple& point, const NumberTriple& direction) {
  m_mechanism.axes.push_back({AxisId(id), point, direction, {}});
}

GearMesh& SetSketch::mesh(int tail, int head, int tailTeeth, int headTeeth, MeshKind kind) {
  GearMesh& mesh = m_mechanism.gearMeshes.emplace_back();
  mesh.id = MeshId("m" + std::to_string(m_mechanism.gearMeshes.size()));
  mesh.tail = idOf(tail);
  mesh.head = idOf(head);
  mesh.tailTeeth = tailTeeth;
  mesh.headTeeth = headTeeth;
  mesh.kind = kind;
  return mesh;
}

WheelId SetSketch::wheel(const std::string& id, LinkOrdinal link) {
  Wheel wheel;
  wheel.id = WheelId(id);
  wheel.link = m_mechanism.links[link].id;
  m_mechanism.wheels.push_back(wheel);
  return wheel.id;
}

void SetSketch::input(LinkOrdinal link, const Number& speed) {
  if (!m_mechanism.inputs) m_mechanism.inputs.emplace();
  m_mechanism.inputs->push_back(
      {m_mechanism.turningJoints[static_cast<std::size_t>(link) - 1].id, speed, {}});
}

void SetSketch::brake(const std::string& id, LinkOrdinal link) {
  m_mechanism.couplings.push_back({ShiftElementId(id), ShiftElementKind::brake, {idOf(link)}, {}});
}

void SetSketch::engage(const std::string& id) {
  m_mechanism.engaged.emplace_back(id);
}

void SetSketch::clutch(const std::string& id, LinkOrdinal link, int other) {
  m_mechanism.couplings.push_back(
      {ShiftElementId(id), ShiftElementKind::clutch, {idOf(link), idOf(other)}, {}});
}

void SetSketch::state(const std::string& name, const std::vector<std::string>& engaged, int drive,
                      int driven) {
  ShiftState& state = m_mechanism.states.emplace_back();
  state.name = name;
  for (const std::string& id : engaged) state.engaged.emplace_back(id);
  state.drive = idOf(drive);
  state.driven = idOf(driven);
}

Mechanism SetSketch::build() && {
  constexpr double kColumn = 190;
  constexpr double kRow = 100;
  int inner = 0;
  int outer = 0;
  for (std::size_t i = 1; i < m_parents.size(); ++i) {
    int& row = m_parents[i] == 0 ? inner : outer;
    m_mechanism.view.nodes[idOf(static_cast<int>(i))] = {(m_parents[i] == 0 ? 1 : 2) * kColumn, row * kRow};
    ++row;
  }
  for (std::size_t i = 1; i < m_parents.size(); ++i) {  // the shorter column beside the middle of the longer
    const int gap = m_parents[i] == 0 ? outer - inner : inner - outer;
    if (gap > 0) m_mechanism.view.nodes[idOf(static_cast<int>(i))].y += gap * kRow / 2;
  }
  m_mechanism.view.nodes[idOf(0)] = {0, (std::max(inner, outer) - 1) * kRow / 2};
  return std::move(m_mechanism);
}

}  // namespace geargraph
