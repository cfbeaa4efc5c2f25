#pragma once

#include <flint/fmpz_mpoly.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/rational.h"
#include "core/exact/prime_field.h"

namespace geargraph {

/// The names of the gear ratios, and FLINT's context for polynomials in them. Make one per thread and
/// analysis.
///
/// Names are text like "i15" (a letter and a label) and print as "i_{15}" in LaTeX. Where the ratios' own
/// values are given, functions know whether they vanish there.
class RatioRing {
 public:
  explicit RatioRing(std::vector<std::string> names, std::vector<Rational> values = {});
  ~RatioRing();
  RatioRing(const RatioRing&) = delete;
  RatioRing& operator=(const RatioRing&) = delete;

  [[nodiscard]] int variables() const { return static_cast<int>(m_names.size()); }
  [[nodiscard]] const std::string& name(int variable) const {
    return m_names[static_cast<std::size_t>(variable)];
  }
  [[nodiscard]] std::span<const Rational> values() const { return m_values; }

  /// FLINT takes the context as non-const everywhere, and never writes to it.
  [[nodiscard]] fmpz_mpoly_ctx_struct* context() const { return m_context; }

 private:
  std::vector<std::string> m_names;
  std::vector<Rational> m_values;
  mutable fmpz_mpoly_ctx_t m_context;
};

using RatioRingPtr = std::shared_ptr<const RatioRing>;

/// A quotient of two polynomials with whole coefficients in the gear ratios, in lowest terms, the
/// denominator's leading coefficient positive: equal functions are equal values. For the paper's robot the
/// single monomials of Eq. (25).
///
/// A default value is 0 of no ring; it may be assigned to, added to and subtracted from.
class RationalFunction {
 public:
  RationalFunction() = default;
  RationalFunction(const RationalFunction& other);
  RationalFunction(RationalFunction&& other) noexcept;
  RationalFunction& operator=(const RationalFunction& other);
  RationalFunction& operator=(RationalFunction&& other) noexcept;
  ~RationalFunction();

  [[nodiscard]] static RationalFunction fromInteger(RatioRingPtr ring, std::int64_t value);
  /// The ratio itself.
  [[nodiscard]] static RationalFunction variable(const RatioRingPtr& ring, int variable);

  [[nodiscard]] bool isZero() const {
    return !m_ring || fmpz_mpoly_is_zero(m_numerator, m_ring->context()) != 0;
  }
  /// Is it 0 at the ring's values? False where the ring has none.
  [[nodiscard]] bool vanishesAtValues() const;
  /// Terms of numerator and denominator together: what a budget counts.
  [[nodiscard]] std::int64_t termCount() const;

  RationalFunction& operator+=(const RationalFunction& other);
  RationalFunction& operator-=(const RationalFunction& other);
  RationalFunction& operator*=(const RationalFunction& other);
  /// @pre other is not 0
  RationalFunction& operator/=(const RationalFunction& other);
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

  /// Its value at these ratios, one for each variable; nothing where the denominator is 0 there.
  [[nodiscard]] std::optional<Rational> valueAt(std::span<const Rational> ratios) const;

  /// "-i18*i17*i16", "i15/i17", "(i16 + 1)/(i15*i17 - 2)": factors in the paper's order, the highest label
  /// first. Every computer algebra system reads it.
  [[nodiscard]] std::string toText() const;
  /// The same for formulas: "-i_{18} i_{17} i_{16}", "\frac{i_{15}}{i_{17}}".
  [[nodiscard]] std::string toLatex() const;

 private:
  explicit RationalFunction(RatioRingPtr ring);
  void normaliseSign();
  void add(const RationalFunction& other, bool negated);
  void multiply(const fmpz_mpoly_t numerator, const fmpz_mpoly_t denominator);
  void swap(RationalFunction& other) noexcept;

  RatioRingPtr m_ring;  ///< null: the default 0, and the polynomials are not initialised
  fmpz_mpoly_t m_numerator;
  fmpz_mpoly_t m_denominator;
};

}  // namespace geargraph
