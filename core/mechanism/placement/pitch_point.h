#pragma once

#include <optional>

#include "core/foundations/base/triple.h"

namespace geargraph {

/// The axes and tooth counts of two gears. Directions need not be unit vectors.
template <class Scalar>
struct GearPair {
  Vector3Of<Scalar> tailPoint;
  Vector3Of<Scalar> tailDirection;
  Vector3Of<Scalar> headPoint;
  Vector3Of<Scalar> headDirection;
  int tailTeeth = 1;
  int headTeeth = 1;
};

/// Where the pitch circles of parallel axes touch: P = (N_j a_i - s N_i a_j) / (N_j - s N_i), a the points of
/// the axes in the plane through `level` normal to them; s = -1 external, +1 internal. This is the operating
/// pitch point, whatever the profile shifts.
/// @pre internal: different tooth counts
template <class Scalar>
[[nodiscard]] Vector3Of<Scalar> parallelPitchPoint(const GearPair<Scalar>& pair, bool internal,
                                                   const Vector3Of<Scalar>& level) {
  const auto foot = [&](const Vector3Of<Scalar>& point, const Vector3Of<Scalar>& direction) {
    const Scalar along = dot(level - point, direction) / dot(direction, direction);
    return point + along * direction;
  };
  const Scalar head(pair.headTeeth);
  const Scalar tail(internal ? pair.tailTeeth : -pair.tailTeeth);
  const Vector3Of<Scalar> sum =
      head * foot(pair.tailPoint, pair.tailDirection) - tail * foot(pair.headPoint, pair.headDirection);
  return (Scalar(1) / (head - tail)) * sum;
}

/// Where intersecting axes intersect (the apex). @pre the lines are coplanar and not parallel
template <class Scalar>
[[nodiscard]] Vector3Of<Scalar> apexOf(const GearPair<Scalar>& pair) {
  const Vector3Of<Scalar> normal = cross(pair.tailDirection, pair.headDirection);
  const Scalar along =
      dot(cross(pair.headPoint - pair.tailPoint, pair.headDirection), normal) / dot(normal, normal);
  return pair.tailPoint + along * pair.tailDirection;
}

/// The half axes, seen from the apex, on which the wheels of a bevel pair are: +1 along the direction, -1
/// against it.
struct BevelSides {
  int tail = 1;
  int head = 1;
};

/// The pitch point of a bevel pair: P = O + m (N_j a u_A + N_i b u_B) between the half axes a u_A and b u_B,
/// with m such that the pitch diameters are teeth times `module`.
[[nodiscard]] Vector3 bevelPitchPoint(const GearPair<double>& pair, BevelSides sides, double module);
/// The same in fractions; std::nullopt if a root is irrational.
[[nodiscard]] std::optional<ExactVector3> bevelPitchPoint(const GearPair<Rational>& pair, BevelSides sides,
                                                          const Rational& module);

}  // namespace geargraph
