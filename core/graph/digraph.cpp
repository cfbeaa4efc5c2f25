#include "core/graph/digraph.h"

namespace geargraph {

Digraph::Digraph(const Mechanism& mechanism) : m_turningCount(mechanism.t()), m_nodeOf(mechanism.links) {
  m_nodes.reserve(mechanism.links.size());
  for (const Link& link : mechanism.links) m_nodes.push_back(link.id);
  const std::size_t edges = mechanism.turningJoints.size() + mechanism.gearMeshes.size();
  m_edges.reserve(edges);
  m_edgeIds.reserve(edges);
  const auto add = [this](const auto& joint) {
    m_edges.push_back({m_nodeOf.at(joint.tail), m_nodeOf.at(joint.head)});
    m_edgeIds.emplace_back(joint.id);
  };
  for (const TurningJoint& joint : mechanism.turningJoints) add(joint);
  for (const GearMesh& mesh : mechanism.gearMeshes) add(mesh);
  collectTurningEdges(mechanism);
}

void Digraph::collectTurningEdges(const Mechanism& mechanism) {
  const PositionIndex<AxisTag> axisAt(mechanism.axes);
  m_axisOf.reserve(mechanism.turningJoints.size());
  m_start.assign(m_nodes.size() + 1, 0);
  for (const TurningJoint& joint : mechanism.turningJoints) {
    const DigraphEdge& edge = m_edges[m_axisOf.size()];
    m_axisOf.push_back(axisAt.at(joint.axis));
    ++m_start[static_cast<std::size_t>(edge.tail)];
    ++m_start[static_cast<std::size_t>(edge.head)];
  }
  // Counting sort: each node's places are filled from their end, so that its edges stand in order.
  int end = 0;
  for (int& start : m_start) end = start += end;
  m_around.resize(2 * m_axisOf.size());
  for (int joint = t() - 1; joint >= 0; --joint) {
    const DigraphEdge& edge = turningEdge(joint);
    m_around[static_cast<std::size_t>(--m_start[static_cast<std::size_t>(edge.tail)])] = joint;
    m_around[static_cast<std::size_t>(--m_start[static_cast<std::size_t>(edge.head)])] = joint;
  }
}

}  // namespace geargraph
