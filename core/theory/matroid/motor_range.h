#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/theory/matroid/exact_solution.h"

namespace geargraph {

/// One end of the limits of a joint as a condition on the angles x, y of two motors, while all other motors
/// stand at the reference pose: gains[0] x + gains[1] y <= bound. Degrees from the reference pose.
struct MotorLimit {
  JointOrdinal joint = 0;
  bool isUpper = true;  ///< the upper end; the lower one has its signs turned round
  std::array<Rational, 2> gains;
  Rational bound;  ///< at least 0: the reference pose is allowed

  [[nodiscard]] bool allows(const Rational& x, const Rational& y) const {
    return gains[0] * x + gains[1] * y <= bound;
  }
};

/// A corner of a range, and which limit bounds the side from it to the next one.
struct MotorCorner {
  Rational x, y;
  /// Into MotorRange::limits; none: nothing limits the motors there, and the side is where the range is cut
  /// off so that it can be shown.
  std::optional<std::size_t> side;
};

/// Where two motors may stand: a convex polygon, counter-clockwise, that holds the reference pose. One or two
/// corners where limits leave a point or a line.
struct MotorRange {
  std::array<JointOrdinal, 2> motors{};
  std::vector<MotorLimit> limits;  ///< of all joints that turn with one of these motors, by joint
  std::vector<MotorCorner> corners;

  /// Do limits bound all of its sides?
  [[nodiscard]] bool isClosed() const;
  /// The most ends of limits that are looked at.
  static constexpr std::size_t kMaxLimits = 256;
};

/// The limits of all joints, not only of those that a controller commands, carried to two motors by the rows
/// of the solution [AU, Eq. (23)]: theta_j = g_x x + g_y y. Exact: corners are where two limits meet, as
/// fractions.
///
/// Identity  a pair of angles is in the polygon just when every joint is within its limits.
/// Cost      O(limits^2) exact operations.
/// std::nullopt above kMaxLimits. @pre both motors are inputs of the solution, not the same; it has its
/// matrix
[[nodiscard]] std::optional<MotorRange> motorRange(const Mechanism& mechanism, const ExactSolution& solution,
                                                   JointOrdinal xMotor, JointOrdinal yMotor);

}  // namespace geargraph
