#include "core/mechanism/model/joint_forest.h"

#include "core/foundations/base/position_index.h"

namespace geargraph {

JointForest::JointForest(const Mechanism& mechanism)
    : m_parent(mechanism.links.size(), -1),
      m_joint(mechanism.links.size(), -1),
      m_depth(mechanism.links.size(), 0) {
  const PositionIndex<LinkTag> links(mechanism.links);
  std::vector<std::vector<std::pair<int, int>>> edges(mechanism.links.size());
  for (int j = 0; j < mechanism.t(); ++j) {
    const TurningJoint& joint = mechanism.turningJoints[static_cast<std::size_t>(j)];
    const int tail = links.positionOf(joint.tail);
    const int head = links.positionOf(joint.head);
    edges[static_cast<std::size_t>(tail)].emplace_back(head, j);
    edges[static_cast<std::size_t>(head)].emplace_back(tail, j);
  }
  for (int root = 0; root < static_cast<int>(edges.size()); ++root) {
    if (m_parent[static_cast<std::size_t>(root)] < 0) hangOn(root, edges);
  }
}

std::vector<int> JointForest::path(int from, int to) const {
  std::vector<int> up;
  std::vector<int> down;
  while (from != to) {
    const bool climbs = depth(from) >= depth(to);
    int& link = climbs ? from : to;
    const int joint = m_joint[static_cast<std::size_t>(link)];
    if (joint < 0) return {};
    (climbs ? up : down).push_back(joint);
    link = m_parent[static_cast<std::size_t>(link)];
  }
  up.insert(up.end(), down.rbegin(), down.rend());
  return up;
}

void JointForest::hangOn(int root, const std::vector<std::vector<std::pair<int, int>>>& edges) {
  std::vector<int> queue{root};
  m_parent[static_cast<std::size_t>(root)] = root;
  for (std::size_t at = 0; at < queue.size(); ++at) {
    const int link = queue[at];
    for (const auto& [next, joint] : edges[static_cast<std::size_t>(link)]) {
      if (m_parent[static_cast<std::size_t>(next)] >= 0) continue;
      m_parent[static_cast<std::size_t>(next)] = link;
      m_joint[static_cast<std::size_t>(next)] = joint;
      m_depth[static_cast<std::size_t>(next)] = depth(link) + 1;
      queue.push_back(next);
    }
  }
}

}  // namespace geargraph
