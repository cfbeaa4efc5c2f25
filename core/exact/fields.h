#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <stop_token>

#include "core/base/contract.h"
#include "core/base/rational.h"
#include "core/exact/prime_field.h"
#include "core/exact/rational_function.h"

namespace geargraph {

// The scalars that the one elimination (elimination.h) is run with. A field offers
//   Value                          copyable; a default one is 0
//   fromInteger(k), one()
//   isZero(value)                  decided exactly, never from a tolerance
//   subtract(a, b)                 a -= b
//   subtractProduct(a, b, c)       a -= b c
//   quotient(a, b)                 a / b, b not 0
//   negated(a)
//   pivotWeight(value)             0: not to be divided by; else larger is better

/// A double beside the same number modulo a prime: the prime decides what is 0, the double is what is shown.
struct Fused {
  double number = 0;
  PrimeField::Residue residue = 0;
};

/// The live arithmetic. One field per thread: it remembers the inverses it computed.
class FusedField {
 public:
  using Value = Fused;

  explicit FusedField(std::uint64_t seed = PrimeField::kFirstSeed) : m_prime(seed) {}

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
  [[nodiscard]] double pivotWeight(const Value& value) const {
    // A double that cancelled to 0 beside a residue that is not: light, but fit where nothing else is.
    constexpr double kLightest = 1e-300;
    return value.residue == 0 ? 0 : std::max(std::abs(value.number), kLightest);
  }

 private:
  /// Trains have few different tooth counts, so a small table answers nearly all.
  [[nodiscard]] PrimeField::Residue inverse(PrimeField::Residue a) const {
    Remembered& place = m_inverses[(a * 0x9e3779b97f4a7c15U) >> 56U];
    if (place.of != a) place = {a, m_prime.inverse(a)};
    return place.inverse;
  }

  struct Remembered {
    PrimeField::Residue of = 0;
    PrimeField::Residue inverse = 0;
  };

  PrimeField m_prime;
  mutable std::array<Remembered, 256> m_inverses{};
};

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
  [[nodiscard]] Value negated(const Value& a) const { return -a; }
  [[nodiscard]] double pivotWeight(const Value& value) const { return value.isZero() ? 0 : 1; }
};

/// Rational functions of the gear ratios.
class RationalFunctionField {
 public:
  using Value = RationalFunction;

  explicit RationalFunctionField(RatioRingPtr ring) : m_ring(std::move(ring)) {}
  /// Asks `enough` to stop, and leaves values as they are from then on, once one has more than `mostTerms`
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
  [[nodiscard]] Value negated(const Value& a) const { return -a; }
  /// Short pivots first; none that vanishes at the ratios' own values, where the ring knows them.
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
