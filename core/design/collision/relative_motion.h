#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <span>
#include <vector>

#include "core/design/collision/collision_parts.h"
#include "core/foundations/base/rational.h"
#include "core/mechanism/graph/spanning_tree.h"
#include "core/theory/pose/forward_kinematics.h"

namespace geargraph {

/// The motion of the joints: constant rates from the reference pose.
struct JointRates {
  const SpanningTree& tree;
  ByJoint<TurningLine> lines;
  ByJoint<double> rates;        ///< rad/s
  std::vector<Rational> exact;  ///< the same in fractions; empty if not known
};

/// The motion of part Q relative to part P: a product of turns about lines, displacement(t) = Exp(line 1,
/// rate 1 t) ... Exp(line m, rate m t), all lines in the reference pose.
///
/// Only turns that change the distance of the two parts are kept: joints at rest are dropped, adjacent turns
/// about one line are merged, and turns at either end are dropped if the part there is a solid of revolution
/// about their line. So meshing wheels, a shaft in its bearing, and a wheel beside an arm on its own axis
/// have no turns.
class RelativeMotion {
 public:
  struct Turn {
    TurningLine line;
    double rate = 0;                ///< rad/s
    std::optional<Rational> exact;  ///< the same
  };

  RelativeMotion(const JointRates& motion, const CollisionPart& p, const CollisionPart& q);

  [[nodiscard]] const std::vector<Turn>& turns() const { return m_turns; }
  /// Can the distance of the parts change at all?
  [[nodiscard]] bool isMoving() const { return !m_turns.empty(); }
  /// The displacement of Q relative to P at `time`, s, from the reference pose.
  [[nodiscard]] Eigen::Isometry3d displacement(double time) const;
  /// The period of the motion of Q relative to P, s; 0: not known, or not periodic.
  [[nodiscard]] double period() const;
  /// The greatest rate, rad/s.
  [[nodiscard]] double fastestRate() const;

 private:
  std::vector<Turn> m_turns;
};

/// Bounds for two parts in all poses of their relative motion.
struct PairBounds {
  bool isClear = false;  ///< they never touch
  double speed = 0;  ///< bound on the rate of change of the distance of any two points of P and Q, length/s
};
/// By bounding spheres; if all lines are parallel also by coordinates along them; and for one line or two
/// parallel ones by distances from it. Cost: O(turns + triangles).
/// @pre the motion has turns
[[nodiscard]] PairBounds pairBounds(const RelativeMotion& motion, const CollisionPart& p,
                                    const CollisionPart& q);

/// A box that contains a part in all poses, base frame. Cost: O(depth).
[[nodiscard]] Eigen::AlignedBox3d sweptBox(const JointRates& motion, const CollisionPart& part);

}  // namespace geargraph
