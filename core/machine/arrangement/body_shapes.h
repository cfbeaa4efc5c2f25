#pragma once

#include <Eigen/Core>
#include <optional>

#include "core/machine/arrangement/arrangement.h"
#include "core/machine/solids/part_solids.h"

namespace geargraph::inline arrangement {

/// Play between an eye and what turns in it, and the wall about it.
[[nodiscard]] inline double eyePlay(const AxisLayout& layout) {
  return 0.08 * layout.module;
}
[[nodiscard]] inline double eyeWall(const AxisLayout& layout) {
  return 1.0 * layout.module;
}

/// Radius of the hole of the parent's eye about the child's shaft; 0: nothing is there.
[[nodiscard]] double holeFor(const Arrangement& plan, int axisClass, double at, int parent);

/// Outer radius of a bearing's eye.
[[nodiscard]] double eyeRadius(const Arrangement& plan, int axisClass, const Bearing& bearing);

/// The eye of an arm about its link's own axis. Its hole lies within the wall of the link's shaft, so that
/// both hold together and no face of one lies on one of the other.
[[nodiscard]] Eye footOf(const Arrangement& plan, const ArmPlan& arm);

/// The other end, in the frame at the arm's level that has its x axis along the base frame's nearest
/// direction across the arm's axis.
[[nodiscard]] Eye endOf(const Arrangement& plan, const ArmPlan& arm);

/// How the end of a post along one axis lies to the middle of the eye about another that it holds.
struct PostEnd {
  Eigen::Vector3d aside = Eigen::Vector3d::Zero();  ///< in the plane of the arm; zero at right angles
  double before = 0;                                ///< along the post
};
/// So that the post meets the eye's wall and leaves its hole free: the edge of its end comes as far as the
/// middle of the wall, and what lies within the wall lies beside the middle of the eye, not beyond its faces.
/// `hole`: the eye's radius. `sense`: 1 where the post runs along the direction of `from`, -1 against it.
/// @pre the axes are not parallel
[[nodiscard]] PostEnd postEnd(const AxisLayout& from, const AxisLayout& to, double hole, double sense);

/// A post from an arm to the bearing on a crossing axis, as far as the bearing's wall.
struct Post {
  Eigen::Vector3d foot;  ///< in the plane of the arm
  Eigen::Vector3d way;   ///< unit vector
  double radius = 0;
  double reach = 0;
};
/// None where the arm holds the bearing itself, or comes near enough.
[[nodiscard]] std::optional<Post> postOf(const Arrangement& plan, const ArmPlan& arm);

}  // namespace geargraph::inline arrangement
