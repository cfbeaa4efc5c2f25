#pragma once

#include <Eigen/Geometry>
#include <span>
#include <vector>

#include "core/mechanism/graph/spanning_tree.h"
#include "core/mechanism/kinds/joint_kind.h"

namespace geargraph {

/// The line that a turning joint turns about, or a sliding joint slides along, in the reference pose, base
/// frame. `direction` has length 1.
struct TurningLine {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();
  JointKind kind = JointKind::turning;
};

/// Where every link is, from the angles of the turning joints and the travels of the sliding ones: T_child =
/// T_parent Exp(u, p, theta), one pass down the spanning tree. Lines are those of the reference pose, so
/// rounding errors do not accumulate from one pose to the next.
///
/// A pose is the displacement from the reference pose: a point that was at x is at pose * x.
class ForwardKinematics {
 public:
  /// `lines` by joint, in the order of the digraph.
  ForwardKinematics(const SpanningTree& tree, std::vector<TurningLine> lines);

  /// Poses by node for these joint angles (rad, by joint; positive turns the head about +direction relative
  /// to the tail), and travels of sliding joints, in the unit of the lines. Angles may be of any size; they
  /// are brought within one turn first. Identity: all angles 0 give identity poses; each link is turned
  /// against its parent by its joint's angle. Cost: O(n).
  /// @pre one angle a joint, one pose a link
  void place(std::span<const double> jointAngles, std::span<Eigen::Isometry3d> poses) const;
  /// The same as a new vector, by node.
  [[nodiscard]] ByLink<Eigen::Isometry3d> poses(std::span<const double> jointAngles) const;

  [[nodiscard]] int linkCount() const { return static_cast<int>(m_steps.size()) + 1; }
  [[nodiscard]] int jointCount() const { return static_cast<int>(m_lines.size()); }
  [[nodiscard]] const TurningLine& line(JointOrdinal joint) const { return m_lines[joint]; }

 private:
  struct Step {
    LinkOrdinal node = 0;
    LinkOrdinal parent = 0;
    JointOrdinal joint = 0;
    double sense = 1;  ///< +1 where the joint's arrow leads away from the ground
  };
  ByJoint<TurningLine> m_lines;
  std::vector<Step> m_steps;  ///< every node after its parent
};

}  // namespace geargraph
