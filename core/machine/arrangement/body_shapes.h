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
