#pragma once

#include <Eigen/Core>
#include <optional>

#include "core/machine/body_layout/arrangement.h"
#include "core/machine/solids/part_solids.h"

namespace geargraph {

/// The radial clearance between a boss and the shaft in it, and the thickness of the boss's wall; lengths.
[[nodiscard]] inline double bossClearance(const AxisLayout& layout) {
  return 0.08 * layout.module;
}
[[nodiscard]] inline double bossWall(const AxisLayout& layout) {
  return 1.0 * layout.module;
}

/// The hole radius of the parent's boss around the child's shaft; 0: no shaft is there.
[[nodiscard]] double holeFor(const Arrangement& plan, AxisGroupOrdinal axisGroup, double at, int parent);

/// The outer radius of a bearing's boss.
[[nodiscard]] double bossRadius(const Arrangement& plan, AxisGroupOrdinal axisGroup, const Bearing& bearing);

/// The hub of an arm on its link's own axis. Its hole is within the wall of the link's shaft, so that the two
/// overlap and no faces coincide.
[[nodiscard]] Boss footOf(const Arrangement& plan, const ArmPlan& arm);

/// The boss at the other end of an arm, in the frame at the arm's level whose x axis is along the direction
/// of the base frame nearest to a normal of the arm's axis.
[[nodiscard]] Boss endOf(const Arrangement& plan, const ArmPlan& arm);

/// The end of a standoff along one axis relative to the centre of the boss on another axis that it supports.
struct StandoffEnd {
  Eigen::Vector3d aside = Eigen::Vector3d::Zero();  ///< in the plane of the arm; zero at right angles
  double before = 0;                                ///< along the standoff
};
/// The end such that the standoff joins the boss's wall and leaves its hole free: the edge of its end reaches
/// the middle of the wall, and the part within the wall does not extend beyond the boss's faces. `hole`:
/// radius of the boss's hole. `sense`: 1 if the standoff runs along the direction of `from`, -1 against it.
/// @pre the axes are not parallel
[[nodiscard]] StandoffEnd standoffEnd(const AxisLayout& from, const AxisLayout& to, double hole,
                                      double sense);

/// A pedestal from an arm to the bearing on an intersecting or skew axis, as far as the bearing's wall.
struct Standoff {
  Eigen::Vector3d foot;  ///< in the plane of the arm
  Eigen::Vector3d way;   ///< unit vector
  double radius = 0;
  double reach = 0;
};
/// std::nullopt if the arm supports the bearing directly.
[[nodiscard]] std::optional<Standoff> standoffOf(const Arrangement& plan, const ArmPlan& arm);

}  // namespace geargraph
