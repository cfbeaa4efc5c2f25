#include "core/placement/joint_tree.h"

#include "core/base/position_index.h"

namespace geargraph {
namespace {

/// Collects the joints at every link (counting sort).
void collectAround(JointTree& tree, std::size_t links) {
  tree.aroundStart.assign(links + 1, 0);
  for (const auto& [tail, head] : tree.joints) {
    ++tree.aroundStart[tail + 1];
    ++tree.aroundStart[head + 1];
  }
  for (std::size_t i = 1; i < tree.aroundStart.size(); ++i) tree.aroundStart[i] += tree.aroundStart[i - 1];
  tree.around.resize(tree.joints.size() * 2);
  std::vector<int> next = tree.aroundStart;
  for (std::size_t j = 0; j < tree.joints.size(); ++j) {
    tree.around[next[tree.joints[j].tail]++] = static_cast<int>(j);
    tree.around[next[tree.joints[j].head]++] = static_cast<int>(j);
  }
}

}  // namespace

std::optional<JointTree> JointTree::of(const Mechanism& mechanism) {
  const std::size_t links = mechanism.links.size();
  if (mechanism.turningJoints.size() + 1 != links) return std::nullopt;

  const PositionIndex<LinkTag> linkAt(mechanism.links);
  const PositionIndex<AxisTag> axisAt(mechanism.axes);

  JointTree tree;
  tree.joints.reserve(mechanism.turningJoints.size());
  for (const TurningJoint& joint : mechanism.turningJoints) {
    tree.joints.push_back({linkAt.at(joint.tail), linkAt.at(joint.head)});
    tree.axisOf.push_back(axisAt.at(joint.axis));
  }
  tree.meshes.reserve(mechanism.gearMeshes.size());
  for (const GearMesh& mesh : mechanism.gearMeshes) {
    tree.meshes.push_back({linkAt.at(mesh.tail), linkAt.at(mesh.head)});
  }

  collectAround(tree, links);
  tree.parent.assign(links, -1);
  tree.joint.assign(links, -1);
  tree.child.assign(tree.joints.size(), -1);
  tree.order.reserve(links);
  tree.order.push_back(0);
  for (std::size_t at = 0; at < tree.order.size(); ++at) {
    const int link = tree.order[at];
    for (int i = tree.aroundStart[link]; i < tree.aroundStart[link + 1]; ++i) {
      const int joint = tree.around[i];
      if (joint == tree.joint[link]) continue;
      const Ends& ends = tree.joints[joint];
      const int other = ends.tail == link ? ends.head : ends.tail;
      if (other == 0 || tree.joint[other] != -1) return std::nullopt;  // a loop
      tree.parent[other] = link;
      tree.joint[other] = joint;
      tree.child[joint] = other;
      tree.order.push_back(other);
    }
  }
  if (tree.order.size() != links) return std::nullopt;  // a loose link
  return tree;
}

}  // namespace geargraph
