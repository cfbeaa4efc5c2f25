#include "core/placement/joint_tree.h"

namespace geargraph {
namespace {

/// The joints at every link, in one array.
struct Neighbours {
  std::vector<int> start;
  std::vector<int> joints;

  Neighbours(const std::vector<JointTree::Ends>& ends, std::size_t links) : start(links + 1, 0) {
    for (const auto& [tail, head] : ends) {
      ++start[tail + 1];
      ++start[head + 1];
    }
    for (std::size_t i = 1; i < start.size(); ++i) start[i] += start[i - 1];
    joints.resize(ends.size() * 2);
    std::vector<int> next = start;
    for (std::size_t j = 0; j < ends.size(); ++j) {
      joints[next[ends[j].tail]++] = static_cast<int>(j);
      joints[next[ends[j].head]++] = static_cast<int>(j);
    }
  }
};

}  // namespace

std::optional<JointTree> JointTree::of(const Mechanism& mechanism) {
  const std::size_t links = mechanism.links.size();
  if (mechanism.turningJoints.size() + 1 != links) return std::nullopt;

  std::unordered_map<LinkId, int> linkAt(links);
  for (std::size_t i = 0; i < links; ++i) linkAt.emplace(mechanism.links[i].id, static_cast<int>(i));
  std::unordered_map<AxisId, int> axisAt(mechanism.axes.size());
  for (std::size_t i = 0; i < mechanism.axes.size(); ++i)
    axisAt.emplace(mechanism.axes[i].id, static_cast<int>(i));

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

  const Neighbours neighbours(tree.joints, links);
  tree.parent.assign(links, -1);
  tree.joint.assign(links, -1);
  tree.child.assign(tree.joints.size(), -1);
  tree.order.reserve(links);
  tree.order.push_back(0);
  for (std::size_t at = 0; at < tree.order.size(); ++at) {
    const int link = tree.order[at];
    for (int i = neighbours.start[link]; i < neighbours.start[link + 1]; ++i) {
      const int joint = neighbours.joints[i];
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
