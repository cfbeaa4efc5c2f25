#pragma once

#include <Eigen/Geometry>
#include <span>
#include <vector>

#include "core/mechanism/graph/spanning_tree.h"
#include "core/theory/pose/forward_kinematics.h"

namespace geargraph::inline pose {

/// How a link moves at a moment, base frame: its angular velocity, and the velocity of its point that is at
/// the origin. Units rad/s, mm/s.
struct LinkTwist {
  Eigen::Vector3d angular{0, 0, 0};
  Eigen::Vector3d linear{0, 0, 0};
  [[nodiscard]] Eigen::Vector3d at(const Eigen::Vector3d& point) const {
    return linear + angular.cross(point);
  }
};

/// Twists by node in the poses that are given: the parent's and the joint's own about its line as it lies
/// now. Identity: the derivative of ForwardKinematics::poses by time. Cost: O(n).
/// @pre one pose a link, one rate (rad/s) a joint
[[nodiscard]] std::vector<LinkTwist> linkTwists(const SpanningTree& tree, const ForwardKinematics& kinematics,
                                                std::span<const Eigen::Isometry3d> poses,
                                                std::span<const double> jointRates);

}  // namespace geargraph::inline pose
