#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <stop_token>

#include "core/foundations/base/contract.h"
#include "core/foundations/base/rational.h"
#include "core/foundations/exact/prime_field.h"
#include "core/foundations/exact/rational_function.h"

namespace geargraph {

// The scalars of the elimination (elimination.h). A field has
//   Value                          copyable; a default one is 0
//   fromInteger(k), one()
//   isZero(value)                  decided exactly, never from a tolerance
//   subtract(a, b)                 a -= b
//   subtractProduct(a, b, c)       a -= b c
//   quotient(a, b)                 a / b, b not 0
//   Sum                            of products; a default one is 0, subtractProduct() adds to it
//   divisor(b), quotient(sum, d)   sum / b, for many sums
//   negated(a)
//   pivotWeight(value)             0: not to be divided by; else larger is better

/// A double together with the same number modulo a prime: the residue decides what is 0, the double is the
/// value.
struct ModularDouble {
  double number = 0;
  PrimeField::Residue residue = 0;
};

/// The arithmetic of live results.
class ModularDoubleField {
 public:
  using Value = ModularDouble;

  explicit ModularDoubleField(std::uint64_t seed = PrimeField::kFirstSeed) : m_prime(seed) {}

  [[nodiscard]] const PrimeField& prime() const { return m_prime; }
  [[nodiscard]] Value one() const { return {1, m_prime.one()}; }
  [[nodiscard]] Value fromInteger(std::int64_t value) const {
    return {static_cast<double>(value), m_prime.fromInteger(value)};
  }
  [[nodiscard]] bool isZero(const Value& value) const { return value.residue == 0; }
  void subtract(Value& a, const Value& b) const {
    a.residue = m_prime.subtract(a.residue, b.residue);
    a.number = a.residue == 0 ? 0 : a.number - b.number;
  }
  void subtractProduct(Value& a, const Value& b, const Value& c) const {
    a.residue = m_prime.subtract(a.residue, m_prime.multiply(b.residue, c.residue));
    a.number = a.residue == 0 ? 0 : a.number - b.number * c.number;
  }
  [[nodiscard]] Value quotient(const Value& a, const Value& b) const {
    return {a.residue == 0 ? 0 : a.number / b.number, m_prime.multiply(a.residue, inverse(b.residue))};
  }
  [[nodiscard]] Value negated(const Value& a) const { return {-a.number, m_prime.negate(a.residue)}; }
  /// value pi^power, with a residue drawn at random for pi: as pi is transcendental, what is not 0 with it is
  /// 0 there by chance only.
  [[nodiscard]] Value timesPi(Value value, int power) const {
    const PrimeField::Residue drawn = ResidueStream(m_prime, 0x7069U).next();
    const PrimeField::Residue factor = power < 0 ? m_prime.inverse(drawn) : drawn;
    for (int i = 0; i < std::abs(power); ++i) value.residue = m_prime.multiply(value.residue, factor);
    value.number *= std::pow(std::numbers::pi, power);
    return value;
  }
  [[nodiscard]] double pivotWeight(const Value& value) const {
    // A double that cancelled to 0 beside a residue that is not: light, but fit where nothing else is.
    constexpr double kLightest = 1e-300;
    return value.residue == 0 ? 0 : std::max(std::abs(value.number), kLightest);
  }

  /// The residue is reduced only at the end, or when two terms may have cancelled before a third one is
  /// added.
  struct Sum {
    double number = 0;
    int terms = 0;
    Wide minusResidue = 0;
  };
  void subtractProduct(Sum& sum, const Value& b, const Value& c) const {
    if (sum.terms++ >= 2 && m_prime.valueOf(sum.minusResidue) == 0) sum.number = 0;
    sum.number -= b.number * c.number;
    sum.minusResidue = m_prime.addProduct(sum.minusResidue, b.residue, c.residue);
  }
  struct Divisor {
    double number = 1;
    PrimeField::Residue minusInverse = 0;
  };
  [[nodiscard]] Divisor divisor(const Value& value) const {
    return {value.number, m_prime.negate(inverse(value.residue))};
  }
  [[nodiscard]] Value quotient(const Sum& sum, const Divisor& by) const {
    const PrimeField::Residue residue = m_prime.multiply(m_prime.valueOf(sum.minusResidue), by.minusInverse);
    return {residue == 0 ? 0 : sum.number / by.number, residue};
  }

 private:
  /// Cached, because trains have few different tooth counts, and the next analysis has the same: a small
  /// table per thread has nearly all of them.
  [[nodiscard]] PrimeField::Residue inverse(PrimeField::Residue a) const {
    struct Remembered {
      PrimeField::Residue of = 0;
      std::uint64_t prime = 0;
      PrimeField::Residue inverse = 0;
    };
    static thread_local std::array<Remembered, 512> inverses{};
    Remembered& place = inverses[(a * 0x9e3779b97f4a7c15U) >> 55U];
    if (place.of != a || place.prime != m_prime.prime()) place = {a, m_prime.prime(), m_prime.inverse(a)};
    return place.inverse;
  }

  PrimeField m_prime;
};

/// whole pi^power in a field that has pi; else the whole number alone, for systems whose unknowns are counted
/// in powers of pi (KinematicModel::piOf()).
template <class Field>
[[nodiscard]] typename Field::Value weightIn(const Field& field, std::int64_t whole, int power) {
  if constexpr (requires { field.timesPi(field.one(), power); }) {
    if (power != 0) return field.timesPi(field.fromInteger(whole), power);
  }
  return field.fromInteger(whole);
}

/// Exact fractions.
class RationalField {
 public:
  using Value = Rational;

  [[nodiscard]] Value one() const { return 1; }
  [[nodiscard]] Value fromInteger(std::int64_t value) const { return value; }
  [[nodiscard]] bool isZero(const Value& value) const { return value.isZero(); }
  void subtract(Value& a, const Value& b) const { a -= b; }
  void subtractProduct(Value& a, const Value& b, const Value& c) const {
    fmpq_submul(a.flint(), b.flint(), c.flint());
  }
  [[nodiscard]] Value quotient(const Value& a, const Value& b) const { return a / b; }
  using Sum = Value;
  [[nodiscard]] const Value& divisor(const Value& value) const { return value; }
  [[nodiscard]] Value negated(const Value& a) const { return -a; }
  [[nodiscard]] double pivotWeight(const Value& value) const { return value.isZero() ? 0 : 1; }
};

/// Rational functions of the gear ratios.
class RationalFunctionField {
 public:
  using Value = RationalFunction;

  explicit RationalFunctionField(RatioRingPtr ring) : m_ring(std::move(ring)) {}
  /// Requests a stop of `enough`, and no longer changes values, as soon as one has more than `mostTerms`
  /// terms.
  RationalFunctionField(RatioRingPtr ring, std::int64_t mostTerms, std::stop_source enough)
      : m_ring(std::move(ring)), m_mostTerms(mostTerms), m_enough(std::move(enough)) {}

  [[nodiscard]] const RatioRingPtr& ring() const { return m_ring; }
  [[nodiscard]] Value one() const { return RationalFunction::fromInteger(m_ring, 1); }
  [[nodiscard]] Value fromInteger(std::int64_t value) const {
    return RationalFunction::fromInteger(m_ring, value);
  }
  [[nodiscard]] bool isZero(const Value& value) const { return value.isZero(); }
  void subtract(Value& a, const Value& b) const { a -= b; }
  void subtractProduct(Value& a, const Value& b, const Value& c) const {
    if (m_mostTerms > 0 && (a.termCount() > m_mostTerms || b.termCount() * c.termCount() > 8 * m_mostTerms)) {
      m_enough.request_stop();
      return;
    }
    a.subtractProduct(b, c);
  }
  [[nodiscard]] Value quotient(const Value& a, const Value& b) const { return a / b; }
  using Sum = Value;
  [[nodiscard]] const Value& divisor(const Value& value) const { return value; }
  [[nodiscard]] Value negated(const Value& a) const { return -a; }
  /// Short pivots first; none that vanishes at the ratios' own values, if the ring has them.
  [[nodiscard]] double pivotWeight(const Value& value) const {
    if (value.isZero() || value.vanishesAtValues()) return 0;
    return 1.0 / static_cast<double>(value.termCount());
  }

 private:
  RatioRingPtr m_ring;
  std::int64_t m_mostTerms = 0;  ///< 0: no limit
  mutable std::stop_source m_enough;
};

}  // namespace geargraph
