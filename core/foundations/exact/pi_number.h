#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/foundations/base/rational.h"

namespace geargraph {

/// An exact number with powers of pi: a sum of fractions times different whole powers of pi. Rates have one
/// where a screw, or a rack given by its pitch, ties a length to an angle; mostly a single term. Pi is
/// transcendental, so that a number is 0 exactly if it has no term.
class PiNumber {
 public:
  struct Term {
    int power = 0;
    Rational factor;  ///< not 0
    friend bool operator==(const Term&, const Term&) = default;
  };

  PiNumber() = default;
  PiNumber(const Rational& value) : PiNumber(value, 0) {}  // NOLINT(google-explicit-constructor)
  /// value pi^power
  PiNumber(const Rational& value, int power);

  [[nodiscard]] bool isZero() const { return m_terms.empty(); }
  /// Without a power of pi?
  [[nodiscard]] bool isRational() const;
  /// @pre isRational()
  [[nodiscard]] Rational rational() const;
  /// The highest power first.
  [[nodiscard]] const std::vector<Term>& terms() const { return m_terms; }
  [[nodiscard]] double toDouble() const;
  [[nodiscard]] PiNumber abs() const { return toDouble() < 0 ? -*this : *this; }
  /// "-3/2", "5/2/pi", "20*pi", "1/3/pi^2", "1/10*pi + 1": computer algebra systems can read it.
  [[nodiscard]] std::string toString() const;

  PiNumber& operator+=(const PiNumber& other);
  PiNumber& operator*=(const PiNumber& other);
  friend PiNumber operator+(PiNumber a, const PiNumber& b) { return a += b; }
  friend PiNumber operator*(PiNumber a, const PiNumber& b) { return a *= b; }
  friend PiNumber operator-(PiNumber a) {
    for (Term& term : a.m_terms) term.factor = -term.factor;
    return a;
  }
  friend PiNumber operator-(const PiNumber& a, const PiNumber& b) { return a + -b; }
  friend bool operator==(const PiNumber&, const PiNumber&) = default;
  /// By their values.
  friend bool operator<(const PiNumber& a, const PiNumber& b);

 private:
  std::vector<Term> m_terms;  ///< powers descending
};

}  // namespace geargraph
