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
}

}  // namespace geargraph
