#pragma once

#include "core/foundations/base/triple.h"

namespace geargraph {

/// The screw (dual vector) of a turning joint about a pitch point [AU, Eq. (6)].
template <class Scalar>
struct Screw {
  Vector3Of<Scalar> direction;  ///< (L M N): the joint's axis, length 1 for the paper's screw
  Vector3Of<Scalar> moment;     ///< (P Q R): velocity of the pitch point at the rate 1, Eq. (10)
};

/// The screw times a joint's rate [AU, Eq. (13)]: angular velocity, and velocity at the pitch point.
template <class Scalar>
struct Twist {
  Vector3Of<Scalar> angular;
  Vector3Of<Scalar> linear;
};

/// The screw of a line about a pitch point: direction u and moment r = l x u, l = p - P [AU, Eqs. (10),
/// (11)]. The paper calls r a position vector; it is the moment of the line about P.
///
/// Identity r = u x (P - p); where all x are 0, Q = R = 0 [AU, Eq. (12)], in general Q = -x cos phi, R = -x
/// sin phi.
template <class Scalar>
[[nodiscard]] Screw<Scalar> screwAbout(const Vector3Of<Scalar>& pitchPoint,
                                       const Vector3Of<Scalar>& axisPoint,
                                       const Vector3Of<Scalar>& direction) {
  return {direction, cross(axisPoint - pitchPoint, direction)};
}

template <class Scalar>
[[nodiscard]] Twist<Scalar> operator*(const Screw<Scalar>& screw, const Scalar& rate) {
  return {rate * screw.direction, rate * screw.moment};
}

/// D_0,k: the rotation about x by phi, row by row [AU, Eq. (8)].
[[nodiscard]] Vector3Of<Vector3> offsetRotation(double phi);

/// The direction of an axis that is turned about x by phi away from z [AU, Eqs. (7), (9)]: (0, -sin phi, cos
/// phi).
[[nodiscard]] Vector3 offsetDirection(double phi);

}  // namespace geargraph
