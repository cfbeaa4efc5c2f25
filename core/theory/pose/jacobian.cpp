#include "core/theory/pose/jacobian.h"

#include "core/theory/pose/modular_pose.h"

namespace geargraph {
namespace {

/// The joints between the ground and a link, from the ground on, with +1 where the link's side is the head.
std::vector<PathStep> pathFromGround(const SpanningTree& tree, LinkOrdinal link) {
  return treePath(tree, 0, link);
}

std::optional<JacobianRank> rankIn(const ExactMotion& motion, LinkOrdinal link, const ExactVector3& point,
                                   bool isReference) {
  const std::vector<PathStep> path = pathFromGround(motion.tree, link);
  const auto field = ModularGeometry::forLines(motion.lines, path);
  if (!field) return std::nullopt;
  const auto jacobian = ModularJacobian::of(*field, motion, path, point, isReference);
  if (!jacobian) return std::nullopt;
  return JacobianRank{jacobian->rank(3), jacobian->rank(6)};
}

}  // namespace

Jacobian pointJacobian(const SpanningTree& tree, const ForwardKinematics& kinematics,
                       std::span<const Eigen::Isometry3d> poses, const Eigen::MatrixXd& gains,
                       LinkOrdinal link, const Eigen::Vector3d& point) {
  Jacobian jacobian = Jacobian::Zero(6, gains.cols());
  const Eigen::Vector3d place = poses[static_cast<std::size_t>(link)] * point;
  for (const PathStep& step : pathFromGround(tree, link)) {
    // The line is fixed in both links of its joint, so the pose of either carries it along.
    const Eigen::Isometry3d& pose = poses[static_cast<std::size_t>(tree.child(step.joint))];
    const TurningLine& line = kinematics.line(step.joint);
    const Eigen::Vector3d direction = step.direction * (pose.linear() * line.direction);
    Eigen::Matrix<double, 6, 1> twist;
    twist << direction, direction.cross(place - pose * line.point);
    jacobian += twist * gains.row(step.joint);
  }
  return jacobian;
}

std::optional<JacobianRank> referenceJacobianRank(const ExactMotion& motion, LinkOrdinal link,
                                                  const ExactVector3& point) {
  return rankIn(motion, link, point, true);
}

std::optional<JacobianRank> genericJacobianRank(const ExactMotion& motion, LinkOrdinal link,
                                                const ExactVector3& point) {
  return rankIn(motion, link, point, false);
}

}  // namespace geargraph
