#pragma once

#include <Eigen/Geometry>
#include <span>
#include <vector>

#include "core/mechanism/graph/spanning_tree.h"
#include "core/theory/pose/forward_kinematics.h"

namespace geargraph {

/// The instantaneous motion of a link, base frame: its angular velocity (rad/s), and the velocity of its
/// point at the origin (the document's length unit per second).
struct LinkTwist {
  Eigen::Vector3d angular{0, 0, 0};
  Eigen::Vector3d linear{0, 0, 0};
  [[nodiscard]] Eigen::Vector3d at(const Eigen::Vector3d& point) const {
    return linear + angular.cross(point);
  }
};

/// Twists by node in these poses: the parent's twist plus that of the joint about its line in the pose.
/// Identity: the derivative of ForwardKinematics::poses by time. Cost: O(n).
/// @pre one pose per link, one rate (rad/s, of sliding joints lengths a second) per joint
[[nodiscard]] std::vector<LinkTwist> linkTwists(const SpanningTree& tree, const ForwardKinematics& kinematics,
                                                std::span<const Eigen::Isometry3d> poses,
                                                std::span<const double> jointRates);

}  // namespace geargraph
