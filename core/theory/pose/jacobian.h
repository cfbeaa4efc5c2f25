#pragma once

#include <Eigen/Geometry>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "core/mechanism/graph/spanning_tree.h"
#include "core/mechanism/placement/axis_line.h"
#include "core/theory/pose/forward_kinematics.h"

namespace geargraph {

/// How a point of a link moves with the inputs: twist = J * input rates.
///
/// Shape  6 x E. Rows 0-2 the angular velocity of the link, rows 3-5 the velocity of the point, base frame;
/// column i for input i at 1 rad/s and the others at rest.
/// Units  1 and the document's length.
using Jacobian = Eigen::Matrix<double, 6, Eigen::Dynamic>;

/// The Jacobian of a point of a link in the pose given by `poses` (by node).
///
/// `gains`, joints x inputs: theta_joint = gains * theta_inputs. `point`: where the point is in the reference
/// pose. Cost: O(depth of the link * E).
[[nodiscard]] Jacobian pointJacobian(const SpanningTree& tree, const ForwardKinematics& kinematics,
                                     std::span<const Eigen::Isometry3d> poses, const Eigen::MatrixXd& gains,
                                     LinkOrdinal link, const Eigen::Vector3d& point);

/// The freedom that a link and a point of it have: ranks of the Jacobian's upper half and of the whole.
struct JacobianRank {
  int angular = 0;  ///< of the orientation, 0..3
  int full = 0;     ///< of orientation and place, 0..6
  friend bool operator==(const JacobianRank&, const JacobianRank&) = default;
};

/// What the exact rank of a Jacobian is computed from.
struct ExactMotion {
  const SpanningTree& tree;
  std::span<const ExactLine> lines;                             ///< by joint
  std::function<Rational(JointOrdinal joint, int input)> gain;  ///< theta_joint = sum of gain * theta_input
  int inputs = 0;
};

/// The rank in the reference pose. Never from a tolerance: modulo a random 61-bit prime in which the lengths
/// of the directions have their square roots, so a rank is never too large, and too small with a chance near
/// 2^-60.
///
/// std::nullopt if no such prime was found: more than a dozen different square roots on one link's path.
[[nodiscard]] std::optional<JacobianRank> referenceJacobianRank(const ExactMotion& motion, LinkOrdinal link,
                                                                const ExactVector3& point);

/// The rank in almost all poses; a reference pose with a smaller rank is singular. Evaluated in a random
/// pose: the inputs' angles are random points of the unit circle modulo the prime, the joints' their exact
/// multiples.
[[nodiscard]] std::optional<JacobianRank> genericJacobianRank(const ExactMotion& motion, LinkOrdinal link,
                                                              const ExactVector3& point);

}  // namespace geargraph
