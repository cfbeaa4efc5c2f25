#include "core/mechanism/graph/digraph.h"

namespace geargraph {

Digraph::Digraph(const Mechanism& mechanism)
    : m_nodeCount(static_cast<int>(mechanism.links.size())), m_turningCount(mechanism.t()) {
  m_nodes.reserve(mechanism.links.size());
  for (const Link& link : mechanism.links) m_nodes.push_back(link.id);
  m_nodeOf = PositionIndex<LinkTag>(m_nodes);
  addEdges(mechanism);
  collectTurningEdges();
}

void Digraph::addEdges(const Mechanism& mechanism) {
  const std::size_t joints = mechanism.turningJoints.size();
  m_edges.reserve(joints + mechanism.gearMeshes.size());
  m_edgeIds.reserve(joints + mechanism.gearMeshes.size());
  m_numbers.resize(3 * joints + m_nodes.size() + 1);
  const auto add = [this](const auto& joint) {
    m_edges.push_back({m_nodeOf.at(joint.tail), m_nodeOf.at(joint.head)});
    m_edgeIds.push_back(joint.id.atom());
  };
  const PositionIndex<AxisTag> axisAt(mechanism.axes);
  int* axis = m_numbers.data();
  for (const TurningJoint& joint : mechanism.turningJoints) {
    add(joint);
    *axis++ = axisAt.at(joint.axis);
  }
  for (const GearMesh& mesh : mechanism.gearMeshes) add(mesh);
}

void Digraph::collectTurningEdges() {
  int* const start = m_numbers.data() + m_turningCount;
  for (const DigraphEdge& edge : turningEdges()) {
    ++start[edge.tail];
    ++start[edge.head];
  }
  // Counting sort: each node's places are filled from their end, so that its edges stand in order.
  int end = m_turningCount + m_nodeCount + 1;
  for (LinkOrdinal node = 0; node < m_nodeCount; ++node) end = start[node] += end;
  start[m_nodeCount] = end;
  for (JointOrdinal joint = m_turningCount - 1; joint >= 0; --joint) {
    const DigraphEdge& edge = turningEdge(joint);
    m_numbers[static_cast<std::size_t>(--start[edge.tail])] = joint;
    m_numbers[static_cast<std::size_t>(--start[edge.head])] = joint;
  }
}

}  // namespace geargraph
