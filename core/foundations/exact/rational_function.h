#pragma once

#include <flint/fmpz_mpoly.h>

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/foundations/base/rational.h"
#include "core/foundations/exact/laurent_polynomial.h"
#include "core/foundations/exact/prime_field.h"

namespace geargraph {

/// The names of the gear ratios, and FLINT's context for polynomials in them. Create one per thread and
/// analysis.
///
/// Names are text like "i15" (a letter and a label) and print as "i_{15}" in LaTeX. If tooth counts are
/// given, functions can be tested for zero at these values.
class RatioRing {
 public:
  /// N_tail and N_head of a mesh.
  struct Teeth {
    int tail = 1;
    int head = 1;
  };

  explicit RatioRing(std::vector<std::string> names, std::vector<Teeth> teeth = {});
  ~RatioRing();
  RatioRing(const RatioRing&) = delete;
  RatioRing& operator=(const RatioRing&) = delete;

  [[nodiscard]] int variables() const { return static_cast<int>(m_names.size()); }
  [[nodiscard]] const std::string& name(int variable) const {
    return m_names[static_cast<std::size_t>(variable)];
  }
  /// N_tail / N_head by variable; empty without teeth. Thread-safe.
  [[nodiscard]] std::span<const Rational> values() const;

  /// FLINT takes the context as non-const everywhere, and never writes to it.
  [[nodiscard]] fmpz_mpoly_ctx_struct* context() const { return m_context; }

 private:
  std::vector<std::string> m_names;
  std::vector<Teeth> m_teeth;
  mutable std::once_flag m_valued;
  mutable std::vector<Rational> m_values;  ///< computed on first use
  mutable fmpz_mpoly_ctx_t m_context;
};

using RatioRingPtr = std::shared_ptr<const RatioRing>;

/// A quotient of two polynomials with integer coefficients in the gear ratios, in lowest terms, the
/// denominator's leading coefficient positive: equal functions are equal values. For the paper's robot the
/// single monomials of Eq. (25).
///
/// Stored as a Laurent polynomial if it is one, which is always so except in coupled equations; else as two
/// FLINT polynomials, which need greatest common divisors.
///
/// A default value is 0 without a ring; it may be assigned to, added to and subtracted from.
class RationalFunction {
 public:
  RationalFunction() = default;
  RationalFunction(const RationalFunction& other)
      : m_ring(other.m_ring), m_laurent(other.m_laurent), m_fraction(copyOf(other.m_fraction)) {}
  RationalFunction(RationalFunction&& other) noexcept = default;
  RationalFunction& operator=(const RationalFunction& other) {
    if (this != &other) *this = RationalFunction(other);
    return *this;
  }
  RationalFunction& operator=(RationalFunction&& other) noexcept = default;
  ~RationalFunction() = default;

  [[nodiscard]] static RationalFunction fromInteger(RatioRingPtr ring, std::int64_t value);
  /// The ratio itself.
  [[nodiscard]] static RationalFunction variable(const RatioRingPtr& ring, int variable);
  /// sign * ratio^power. @pre |power| < 128
  [[nodiscard]] static RationalFunction power(const RatioRingPtr& ring, int sign, int variable, int power);

  [[nodiscard]] bool isZero() const { return !m_fraction && m_laurent.isZero(); }
  [[nodiscard]] bool isOne() const { return !m_fraction && m_laurent.isOne(); }
  /// Is it 0 at the ring's values? False if the ring has none.
  [[nodiscard]] bool vanishesAtValues() const;
  /// The number of terms of numerator and denominator, for budgets.
  [[nodiscard]] std::int64_t termCount() const;
  /// The number of terms and their factors, to which the length of its text is proportional. Cost: O(1), for
  /// quotients that are no Laurent polynomials O(terms * ratios).
  [[nodiscard]] std::int64_t size() const;

  RationalFunction& operator+=(const RationalFunction& other);
  RationalFunction& operator-=(const RationalFunction& other);
  RationalFunction& operator*=(const RationalFunction& other);
  /// @pre other is not 0
  RationalFunction& operator/=(const RationalFunction& other);
  /// this -= b * c
  void subtractProduct(const RationalFunction& b, const RationalFunction& c);
  friend RationalFunction operator+(RationalFunction a, const RationalFunction& b) {
    return std::move(a += b);
  }
  friend RationalFunction operator-(RationalFunction a, const RationalFunction& b) {
    return std::move(a -= b);
  }
  friend RationalFunction operator*(RationalFunction a, const RationalFunction& b) {
    return std::move(a *= b);
  }
  friend RationalFunction operator/(RationalFunction a, const RationalFunction& b) {
    return std::move(a /= b);
  }
  friend RationalFunction operator-(RationalFunction a);
  friend bool operator==(const RationalFunction& a, const RationalFunction& b);

  /// The value at these ratios, one per variable; std::nullopt if the denominator is 0 there.
  [[nodiscard]] std::optional<Rational> valueAt(std::span<const Rational> ratios) const;

  /// "-i18*i17*i16", "i15/i17", "(i16 + 1)/(i15*i17 - 2)": factors in the paper's order, the highest label
  /// first. Computer algebra systems can read it.
  [[nodiscard]] std::string toText() const;
  /// The same for formulas: "-i_{18} i_{17} i_{16}", "\frac{i_{15}}{i_{17}}".
  [[nodiscard]] std::string toLatex() const;

 private:
  class Fraction;
  struct FractionDeleter {
    void operator()(Fraction* fraction) const;
  };
  using FractionPtr = std::unique_ptr<Fraction, FractionDeleter>;
  class Printer;

  /// A term of the numerator or the denominator: its ratios ascending, with their powers.
  struct Term {
    Rational coefficient;
    std::vector<std::pair<int, unsigned long>> powers;
  };
  using Terms = std::vector<Term>;
  struct Quotient {
    Terms above;
    Terms below;
  };
  [[nodiscard]] static FractionPtr copyOf(const FractionPtr& fraction) {
    return fraction ? duplicateOf(*fraction) : nullptr;
  }
  [[nodiscard]] static FractionPtr duplicateOf(const Fraction& fraction);
  [[nodiscard]] Quotient quotient() const;
  [[nodiscard]] Quotient quotientOfLaurent() const;
  [[nodiscard]] static Rational valueOf(const Terms& terms, std::span<const Rational> ratios);
  void combine(const RationalFunction& other, bool negated);
  void multiply(const RationalFunction& other, bool inverse);
  [[nodiscard]] Fraction asFraction() const;
  void setFraction(Fraction fraction);

  RatioRingPtr m_ring;  ///< null: the default 0
  LaurentPolynomial m_laurent;
  FractionPtr m_fraction;  ///< if it is no Laurent polynomial; m_laurent is 0 then
};

}  // namespace geargraph
