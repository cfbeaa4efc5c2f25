#include "core/theory/pose/forward_kinematics.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "core/foundations/base/contract.h"

namespace geargraph {
namespace {

/// Exp(u, p, theta): x -> p + Rot(u, theta) (x - p).
Eigen::Isometry3d turnAbout(const TurningLine& line, double angle) {
  Eigen::Isometry3d turn = Eigen::Isometry3d::Identity();
  turn.linear() = Eigen::AngleAxisd(angle, line.direction).toRotationMatrix();
  turn.translation() = line.point - turn.linear() * line.point;
  return turn;
}

}  // namespace

ForwardKinematics::ForwardKinematics(const SpanningTree& tree, std::vector<TurningLine> lines)
    : m_lines(std::move(lines)) {
  GEARGRAPH_REQUIRE(static_cast<int>(m_lines.size()) == tree.nodeCount() - 1);
  for (const LinkOrdinal node : tree.preorder().subspan(1)) {
    const JointOrdinal joint = tree.jointToParent(node);
    m_steps.push_back({node, tree.parent(node), joint, -static_cast<double>(tree.directionToGround(joint))});
  }
}

void ForwardKinematics::place(std::span<const double> jointAngles, std::span<Eigen::Isometry3d> poses) const {
  GEARGRAPH_REQUIRE(jointAngles.size() == m_lines.size() && poses.size() == m_steps.size() + 1);
  poses[0] = Eigen::Isometry3d::Identity();
  for (const Step& step : m_steps) {
    const auto joint = static_cast<std::size_t>(step.joint);
    const TurningLine& line = m_lines[joint];
    Eigen::Isometry3d& pose = poses[static_cast<std::size_t>(step.node)];
    pose = poses[static_cast<std::size_t>(step.parent)];
    if (line.kind == JointKind::sliding) {
      pose.translate(step.sense * jointAngles[joint] * line.direction);
    } else {
      const double angle = std::remainder(jointAngles[joint], 2 * std::numbers::pi);
      pose = pose * turnAbout(line, step.sense * angle);
    }
  }
}

ByLink<Eigen::Isometry3d> ForwardKinematics::poses(std::span<const double> jointAngles) const {
  ByLink<Eigen::Isometry3d> result(m_steps.size() + 1);
  place(jointAngles, result);
  return result;
}

}  // namespace geargraph
