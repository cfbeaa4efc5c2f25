#pragma once

#include <array>
#include <cmath>

#include "core/foundations/base/rational.h"

namespace geargraph {

/// A point or vector in the base frame, x y z, in doubles or exact.
template <class Scalar>
using Vector3Of = std::array<Scalar, 3>;
using Vector3 = Vector3Of<double>;
using ExactVector3 = Vector3Of<Rational>;

template <class Scalar>
[[nodiscard]] Vector3Of<Scalar> operator+(const Vector3Of<Scalar>& a, const Vector3Of<Scalar>& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
template <class Scalar>
[[nodiscard]] Vector3Of<Scalar> operator-(const Vector3Of<Scalar>& a, const Vector3Of<Scalar>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
template <class Scalar>
[[nodiscard]] Vector3Of<Scalar> operator*(const Scalar& factor, const Vector3Of<Scalar>& a) {
  return {factor * a[0], factor * a[1], factor * a[2]};
}
template <class Scalar>
[[nodiscard]] Scalar dot(const Vector3Of<Scalar>& a, const Vector3Of<Scalar>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
template <class Scalar>
[[nodiscard]] Vector3Of<Scalar> cross(const Vector3Of<Scalar>& a, const Vector3Of<Scalar>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
[[nodiscard]] inline double length(const Vector3& a) {
  return std::sqrt(dot(a, a));
}
[[nodiscard]] inline Vector3 unit(const Vector3& a) {
  return (1 / length(a)) * a;
}
[[nodiscard]] inline Vector3 toDoubles(const ExactVector3& a) {
  return {a[0].toDouble(), a[1].toDouble(), a[2].toDouble()};
}

}  // namespace geargraph
