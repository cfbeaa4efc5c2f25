#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <span>
#include <vector>

#include "core/design/collision/collision_parts.h"
#include "core/foundations/base/rational.h"
#include "core/mechanism/graph/spanning_tree.h"
#include "core/theory/pose/forward_kinematics.h"

namespace geargraph::inline collision {

/// How the joints of a mechanism turn: at constant rates from the reference pose.
struct JointRates {
  const SpanningTree& tree;
  std::vector<TurningLine> lines;  ///< by joint
  std::vector<double> rates;       ///< rad/s, by joint
  std::vector<Rational> exact;     ///< the same; empty where they are not known in fractions
};

/// How part Q moves as seen from part P: turns about lines, one after the other,
/// displacement(t) = Exp(line 1, rate 1 t) ... Exp(line m, rate m t), all lines in the reference pose.
///
/// Only what changes the distance of the two parts is left: joints at rest are dropped, neighbours on one
/// line become one, and the turns at either end go where the part there is a solid of revolution about their
/// line. So meshing wheels, a shaft in its bearing, and a wheel beside an arm on its own axis have no turns
/// left.
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
  [[nodiscard]] Eigen::Isometry3d displacement(double time) const;
  /// The time after which Q is where it was, seen from P, s; 0: not known, or never.
  [[nodiscard]] double period() const;
  /// The greatest rate, rad/s.
  [[nodiscard]] double fastestRate() const;

 private:
  std::vector<Turn> m_turns;
};

/// What holds for the parts in all poses of their relative motion.
struct PairBounds {
  bool isClear = false;  ///< they never touch
  double speed = 0;      ///< the distance of no point of P and no point of Q changes faster, length/s
};
/// By balls; where all lines are parallel by coordinates along them; and about one line or two parallel ones
/// by distances from it. Cost: O(turns + triangles).
/// @pre the motion has turns
[[nodiscard]] PairBounds pairBounds(const RelativeMotion& motion, const CollisionPart& p,
                                    const CollisionPart& q);

/// A box that a part never leaves, base frame. Cost: O(depth).
[[nodiscard]] Eigen::AlignedBox3d sweptBox(const JointRates& motion, const CollisionPart& part);

}  // namespace geargraph::inline collision
