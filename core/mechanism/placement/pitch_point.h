#pragma once

#include <optional>

#include "core/foundations/base/triple.h"

namespace geargraph::inline placement {

/// The axes and tooth counts of two gears. Directions need not be unit vectors.
template <class Scalar>
struct GearPair {
  Triple<Scalar> tailPoint;
  Triple<Scalar> tailDirection;
  Triple<Scalar> headPoint;
  Triple<Scalar> headDirection;
  int tailTeeth = 1;
  int headTeeth = 1;
};

/// Where the pitch circles of parallel axes touch: P = (N_j a_i - s N_i a_j) / (N_j - s N_i), a the points of
/// the axes in the plane through `level` normal to them; s = -1 external, +1 internal. This is the operating
/// pitch point, whatever the profile shifts.
/// @pre internal: different tooth counts
template <class Scalar>
[[nodiscard]] Triple<Scalar> parallelPitchPoint(const GearPair<Scalar>& pair, bool internal,
                                                const Triple<Scalar>& level) {
  const auto foot = [&](const Triple<Scalar>& point, const Triple<Scalar>& direction) {
    const Scalar along = dot(level - point, direction) / dot(direction, direction);
    return point + along * direction;
  };
  const Scalar head(pair.headTeeth);
  const Scalar tail(internal ? pair.tailTeeth : -pair.tailTeeth);
  const Triple<Scalar> sum =
      head * foot(pair.tailPoint, pair.tailDirection) - tail * foot(pair.headPoint, pair.headDirection);
  return (Scalar(1) / (head - tail)) * sum;
}

/// Where intersecting axes intersect (the apex). @pre the lines are coplanar and not parallel
template <class Scalar>
[[nodiscard]] Triple<Scalar> apexOf(const GearPair<Scalar>& pair) {
  const Triple<Scalar> normal = cross(pair.tailDirection, pair.headDirection);
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

}  // namespace geargraph::inline placement
