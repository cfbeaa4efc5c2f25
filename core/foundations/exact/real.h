#pragma once

#include <optional>
#include <utility>

#include "core/foundations/base/rational.h"

namespace geargraph {

/// A real number as a double, and as a fraction if it is known to be one. Sums and products of exact numbers
/// are exact; values from roots or measurements are not.
class Real {
 public:
  Real() = default;        ///< 0, exactly
  Real(Rational fraction)  // NOLINT(google-explicit-constructor)
      : m_number(fraction.toDouble()), m_fraction(std::move(fraction)) {}
  Real(int whole) : Real(Rational(whole)) {}  // NOLINT(google-explicit-constructor)
  [[nodiscard]] static Real inexact(double number) {
    Real real;
    real.m_number = number;
    real.m_fraction.reset();
    return real;
  }

  [[nodiscard]] double number() const { return m_number; }
  /// std::nullopt if it is not known to be one.
  [[nodiscard]] const std::optional<Rational>& fraction() const { return m_fraction; }
  [[nodiscard]] bool isExact() const { return m_fraction.has_value(); }
  [[nodiscard]] bool isZero() const { return m_fraction ? m_fraction->isZero() : m_number == 0; }
  /// -1, 0 or 1.
  [[nodiscard]] int sign() const {
    if (m_fraction) return m_fraction->sign();
    return m_number < 0 ? -1 : (m_number > 0 ? 1 : 0);
  }
  [[nodiscard]] Real abs() const { return sign() < 0 ? -*this : *this; }

  friend Real operator+(const Real& a, const Real& b) {
    if (a.m_fraction && b.m_fraction) return *a.m_fraction + *b.m_fraction;
    return inexact(a.m_number + b.m_number);
  }
  friend Real operator-(const Real& a) { return a.m_fraction ? Real(-*a.m_fraction) : inexact(-a.m_number); }
  friend Real operator-(const Real& a, const Real& b) { return a + -b; }
  /// An exact zero times any number is an exact zero.
  friend Real operator*(const Real& a, const Real& b) {
    if (a.isExactZero() || b.isExactZero()) return {};
    if (a.m_fraction && b.m_fraction) return *a.m_fraction * *b.m_fraction;
    return inexact(a.m_number * b.m_number);
  }
  /// @pre b is not 0
  friend Real operator/(const Real& a, const Real& b) {
    if (a.isExactZero()) return {};
    if (a.m_fraction && b.m_fraction) return *a.m_fraction / *b.m_fraction;
    return inexact(a.m_number / b.m_number);
  }
  Real& operator+=(const Real& other) { return *this = *this + other; }
  Real& operator-=(const Real& other) { return *this = *this - other; }
  friend bool operator==(const Real& a, const Real& b) {
    return a.m_fraction == b.m_fraction && (a.m_fraction || a.m_number == b.m_number);
  }

 private:
  [[nodiscard]] bool isExactZero() const { return m_fraction && m_fraction->isZero(); }

  double m_number = 0;
  std::optional<Rational> m_fraction = Rational(0);
};

}  // namespace geargraph
