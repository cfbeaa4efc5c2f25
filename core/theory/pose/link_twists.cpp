#include "core/theory/pose/link_twists.h"

#include "core/foundations/base/contract.h"

namespace geargraph {

std::vector<LinkTwist> linkTwists(const SpanningTree& tree, const ForwardKinematics& kinematics,
                                  std::span<const Eigen::Isometry3d> poses,
                                  std::span<const double> jointRates) {
  GEARGRAPH_REQUIRE(static_cast<int>(poses.size()) == tree.nodeCount() &&
                    static_cast<int>(jointRates.size()) == kinematics.jointCount());
  ByLink<LinkTwist> twists(poses.size());
  for (const LinkOrdinal node : tree.preorder()) {
    if (node == 0) continue;
    const auto parent = static_cast<std::size_t>(tree.parent(node));
    const JointOrdinal joint = tree.jointToParent(node);
    const TurningLine& line = kinematics.line(joint);
    const double rate = -tree.directionToGround(joint) * jointRates[static_cast<std::size_t>(joint)];
    const Eigen::Vector3d about = rate * (poses[parent].linear() * line.direction);
    LinkTwist& twist = twists[node];
    if (line.kind == JointKind::sliding) {
      twist.angular = twists[parent].angular;
      twist.linear = twists[parent].linear + about;
      continue;
    }
    twist.angular = twists[parent].angular + about;
    twist.linear = twists[parent].linear + (poses[parent] * line.point).cross(about);
  }
  return twists;
}

}  // namespace geargraph
