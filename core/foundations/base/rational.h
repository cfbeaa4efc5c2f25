#pragma once

#include <flint/fmpq.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace geargraph {

/// An exact fraction of integers of any size, always in lowest terms with a positive denominator. Wraps
/// FLINT's fmpq; small ones (below 2^62) do not allocate.
class Rational {
 public:
  Rational() { fmpq_init(m_value); }
  Rational(std::int64_t whole) : Rational() {
    fmpq_set_si(m_value, whole, 1);
  }  // NOLINT(google-explicit-constructor)
  /// @pre denominator is not 0
  Rational(std::int64_t numerator, std::int64_t denominator);
  Rational(const Rational& other) : Rational() { fmpq_set(m_value, other.m_value); }
  Rational(Rational&& other) noexcept : Rational() { fmpq_swap(m_value, other.m_value); }
  Rational& operator=(const Rational& other) {
    fmpq_set(m_value, other.m_value);
    return *this;
  }
  Rational& operator=(Rational&& other) noexcept {
    fmpq_swap(m_value, other.m_value);
    return *this;
  }
  ~Rational() { fmpq_clear(m_value); }

  /// Reads "3", "-22/7", "0.125" or "1.5e-3", exactly. std::nullopt if the text is none of these, the
  /// denominator is 0, or the number has more than 4,300 digits or an exponent beyond ±4,300 (so that a
  /// malicious file cannot take minutes).
  [[nodiscard]] static std::optional<Rational> fromText(std::string_view text);
  /// The exact value of a finite double.
  [[nodiscard]] static Rational fromDouble(double value);

  [[nodiscard]] bool isZero() const { return fmpq_is_zero(m_value) != 0; }
  [[nodiscard]] bool isInteger() const { return fmpz_is_one(fmpq_denref(m_value)) != 0; }
  [[nodiscard]] int sign() const { return fmpq_sgn(m_value); }
  /// The nearest double (ties to even), infinite beyond the range.
  [[nodiscard]] double toDouble() const;
  /// "-3/2", "5": lowest terms, as the command line prints exact values.
  [[nodiscard]] std::string toString() const;
  [[nodiscard]] Rational abs() const;
  /// @pre not zero
  [[nodiscard]] Rational inverse() const;
  /// The exact root if the value is the square of a fraction, else std::nullopt.
  [[nodiscard]] std::optional<Rational> squareRoot() const;

  Rational& operator+=(const Rational& other) {
    fmpq_add(m_value, m_value, other.m_value);
    return *this;
  }
  Rational& operator-=(const Rational& other) {
    fmpq_sub(m_value, m_value, other.m_value);
    return *this;
  }
  Rational& operator*=(const Rational& other) {
    fmpq_mul(m_value, m_value, other.m_value);
    return *this;
  }
  /// @pre other is not zero
  Rational& operator/=(const Rational& other);

  friend Rational operator+(Rational a, const Rational& b) { return a += b; }
  friend Rational operator-(Rational a, const Rational& b) { return a -= b; }
  friend Rational operator*(Rational a, const Rational& b) { return a *= b; }
  friend Rational operator/(Rational a, const Rational& b) { return a /= b; }
  friend Rational operator-(Rational a) {
    fmpq_neg(a.m_value, a.m_value);
    return a;
  }
  friend bool operator==(const Rational& a, const Rational& b) {
    return fmpq_equal(a.m_value, b.m_value) != 0;
  }
  friend bool operator!=(const Rational& a, const Rational& b) { return !(a == b); }
  friend bool operator<(const Rational& a, const Rational& b) { return fmpq_cmp(a.m_value, b.m_value) < 0; }
  friend bool operator>(const Rational& a, const Rational& b) { return b < a; }
  friend bool operator<=(const Rational& a, const Rational& b) { return !(b < a); }
  friend bool operator>=(const Rational& a, const Rational& b) { return !(a < b); }

  /// FLINT's own value, for the exact engine.
  [[nodiscard]] const fmpq* flint() const { return m_value; }
  [[nodiscard]] fmpq* flint() { return m_value; }

 private:
  fmpq_t m_value;
};

}  // namespace geargraph
