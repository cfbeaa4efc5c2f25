#include "core/foundations/exact/rational_function.h"

#include <algorithm>
#include <map>
#include <utility>

#include "core/foundations/base/contract.h"

namespace geargraph {
namespace {

/// Owns a polynomial, 0 at first.
class Polynomial {
 public:
  explicit Polynomial(const RatioRing& ring) : m_context(ring.context()) {
    fmpz_mpoly_init(m_value, m_context);
  }
  Polynomial(const Polynomial& other) : m_context(other.m_context) {
    fmpz_mpoly_init(m_value, m_context);
    fmpz_mpoly_set(m_value, other.m_value, m_context);
  }
  Polynomial& operator=(const Polynomial&) = delete;
  Polynomial(Polynomial&& other) noexcept : m_context(other.m_context) {
    fmpz_mpoly_init(m_value, m_context);
    fmpz_mpoly_swap(m_value, other.m_value, m_context);
  }
  ~Polynomial() { fmpz_mpoly_clear(m_value, m_context); }
  operator fmpz_mpoly_struct*() { return m_value; }              // NOLINT(google-explicit-constructor)
  operator const fmpz_mpoly_struct*() const { return m_value; }  // NOLINT(google-explicit-constructor)

  [[nodiscard]] slong length() const { return fmpz_mpoly_length(m_value, m_context); }
  [[nodiscard]] bool isOne() const { return fmpz_mpoly_is_one(m_value, m_context) != 0; }
  void swap(Polynomial& other) { fmpz_mpoly_swap(m_value, other.m_value, m_context); }
  [[nodiscard]] Rational coefficient(slong term) const {
    Rational result;
    fmpz_mpoly_get_term_coeff_fmpz(fmpq_numref(result.flint()), m_value, term, m_context);
    return result;
  }
  /// The powers of all ratios in a term.
  void powers(slong term, std::vector<ulong>& result) const {
    fmpz_mpoly_get_term_exp_ui(result.data(), m_value, term, m_context);
  }

 private:
  fmpz_mpoly_ctx_struct* m_context;
  fmpz_mpoly_t m_value;
};

/// a and b without their greatest common divisor. Where FLINT finds none (exponents too large for it) they
/// stay, which is right too, only longer.
void cancel(Polynomial& a, Polynomial& b, const RatioRing& ring) {
  if (a.isOne() || b.isOne()) return;
  Polynomial divisor(ring);
  Polynomial left(ring);
  Polynomial right(ring);
  if (fmpz_mpoly_gcd_cofactors(divisor, left, right, a, b, ring.context()) == 0) return;
  a.swap(left);
  b.swap(right);
}

}  // namespace

RatioRing::RatioRing(std::vector<std::string> names, std::vector<Teeth> teeth)
    : m_names(std::move(names)), m_teeth(std::move(teeth)) {
  GEARGRAPH_REQUIRE(m_teeth.empty() || m_teeth.size() == m_names.size());
  fmpz_mpoly_ctx_init(m_context, static_cast<slong>(m_names.size()), ORD_LEX);
}

RatioRing::~RatioRing() {
  fmpz_mpoly_ctx_clear(m_context);
}

std::span<const Rational> RatioRing::values() const {
  std::call_once(m_valued, [this] {
    m_values.reserve(m_teeth.size());
    for (const Teeth& teeth : m_teeth) m_values.emplace_back(teeth.tail, teeth.head);
  });
  return m_values;
}

/// Numerator and denominator, both not 0.
class RationalFunction::Fraction {
 public:
  explicit Fraction(const RatioRing& ring) : m_ring(ring), m_above(ring), m_below(ring) {}

  [[nodiscard]] bool isZero() const { return m_above.length() == 0; }
  [[nodiscard]] const Polynomial& above() const { return m_above; }
  [[nodiscard]] const Polynomial& below() const { return m_below; }

  static Fraction fromInteger(const RatioRing& ring, std::int64_t value) {
    Fraction result(ring);
    fmpz_mpoly_set_si(result.m_above, value, ring.context());
    fmpz_mpoly_one(result.m_below, ring.context());
    return result;
  }

  static Fraction of(const LaurentPolynomial& laurent, const RatioRing& ring) {
    Fraction result = fromInteger(ring, 0);
    std::vector<ulong> below(static_cast<std::size_t>(ring.variables()), 0);
    laurent.forEachTerm([&](const LaurentPolynomial::Term& term) {
      for (const std::uint32_t power : term.powers) {
        ulong& most = below[static_cast<std::size_t>(LaurentPolynomial::ratioOf(power))];
        most = std::max(most, static_cast<ulong>(std::max(0, -LaurentPolynomial::powerOf(power))));
      }
    });
    laurent.forEachTerm([&](const LaurentPolynomial::Term& term) {
      std::vector<ulong> powers = below;
      for (const std::uint32_t power : term.powers) {
        powers[static_cast<std::size_t>(LaurentPolynomial::ratioOf(power))] +=
            static_cast<ulong>(static_cast<slong>(LaurentPolynomial::powerOf(power)));
      }
      fmpz_mpoly_push_term_si_ui(result.m_above, term.coefficient, powers.data(), ring.context());
    });
    fmpz_mpoly_zero(result.m_below, ring.context());
    fmpz_mpoly_push_term_si_ui(result.m_below, 1, below.data(), ring.context());
    return result;
  }

  /// Nothing where it is none, or its numbers have no room there.
  [[nodiscard]] std::optional<LaurentPolynomial> asLaurent() const {
    if (m_below.length() != 1 || m_below.coefficient(0) != Rational(1)) return std::nullopt;
    std::vector<ulong> below(static_cast<std::size_t>(m_ring.variables()));
    std::vector<ulong> above(below.size());
    std::vector<std::uint32_t> powers;
    m_below.powers(0, below);
    LaurentPolynomial result;
    for (slong term = 0; term < m_above.length(); ++term) {
      const Rational coefficient = m_above.coefficient(term);
      const fmpz* const whole = fmpq_numref(coefficient.flint());
      if (fmpz_fits_si(whole) == 0 || !LaurentPolynomial::isCoefficient(fmpz_get_si(whole)))
        return std::nullopt;
      m_above.powers(term, above);
      powers.clear();
      for (std::size_t i = 0; i < above.size(); ++i) {
        const auto power = static_cast<slong>(above[i] - below[i]);
        if (power > LaurentPolynomial::kMaxPower || power < -LaurentPolynomial::kMaxPower)
          return std::nullopt;
        if (power != 0) {
          powers.push_back(LaurentPolynomial::packed(static_cast<int>(i), static_cast<int>(power)));
        }
      }
      result.append({fmpz_get_si(whole), powers});
    }
    return result;
  }

  void add(const Fraction& other, bool negated) {
    fmpz_mpoly_ctx_struct* context = m_ring.context();
    const auto combine = negated ? fmpz_mpoly_sub : fmpz_mpoly_add;
    if (fmpz_mpoly_equal(m_below, other.m_below, context) != 0) {
      combine(m_above, m_above, other.m_above, context);
    } else {
      Polynomial mine(m_ring);
      Polynomial theirs(m_ring);
      fmpz_mpoly_mul(mine, m_above, other.m_below, context);
      fmpz_mpoly_mul(theirs, other.m_above, m_below, context);
      combine(m_above, mine, theirs, context);
      fmpz_mpoly_mul(m_below, m_below, other.m_below, context);
    }
    if (isZero()) {
      fmpz_mpoly_one(m_below, context);
    } else {
      cancel(m_above, m_below, m_ring);
      normaliseSign();
    }
  }

  void multiply(const Fraction& other, bool inverse) {
    fmpz_mpoly_ctx_struct* context = m_ring.context();
    Polynomial above(inverse ? other.m_below : other.m_above);
    Polynomial below(inverse ? other.m_above : other.m_below);
    cancel(m_above, below, m_ring);  // across: each side is in lowest terms already
    cancel(above, m_below, m_ring);
    fmpz_mpoly_mul(m_above, m_above, above, context);
    fmpz_mpoly_mul(m_below, m_below, below, context);
    normaliseSign();
  }

  void negate() { fmpz_mpoly_neg(m_above, m_above, m_ring.context()); }

  friend bool operator==(const Fraction& a, const Fraction& b) {
    return fmpz_mpoly_equal(a.m_above, b.m_above, a.m_ring.context()) != 0 &&
           fmpz_mpoly_equal(a.m_below, b.m_below, a.m_ring.context()) != 0;
  }

 private:
  void normaliseSign() {
    if (m_below.coefficient(0).sign() > 0) return;
    fmpz_mpoly_neg(m_above, m_above, m_ring.context());
    fmpz_mpoly_neg(m_below, m_below, m_ring.context());
  }

  const RatioRing& m_ring;
  Polynomial m_above;
  Polynomial m_below;
};

void RationalFunction::FractionDeleter::operator()(Fraction* fraction) const {
  delete fraction;
}

RationalFunction::FractionPtr RationalFunction::duplicateOf(const Fraction& fraction) {
  return FractionPtr(new Fraction(fraction));
}

RationalFunction RationalFunction::fromInteger(RatioRingPtr ring, std::int64_t value) {
  RationalFunction result;
  result.m_ring = std::move(ring);
  if (LaurentPolynomial::isCoefficient(value)) {
    result.m_laurent = LaurentPolynomial::term(value);
  } else {
    result.setFraction(Fraction::fromInteger(*result.m_ring, value));
  }
  return result;
}

RationalFunction RationalFunction::variable(const RatioRingPtr& ring, int variable) {
  return power(ring, 1, variable, 1);
}

RationalFunction RationalFunction::power(const RatioRingPtr& ring, int sign, int variable, int power) {
  RationalFunction result;
  result.m_ring = ring;
  result.m_laurent = LaurentPolynomial::term(sign, variable, power);
  return result;
}

std::int64_t RationalFunction::termCount() const {
  return m_fraction ? m_fraction->above().length() + m_fraction->below().length() : m_laurent.termCount() + 1;
}

std::int64_t RationalFunction::size() const {
  if (!m_fraction) return static_cast<std::int64_t>(m_laurent.size());
  const Quotient parts = quotient();
  std::size_t size = 0;
  for (const Terms* terms : {&parts.above, &parts.below}) {
    for (const Term& term : *terms) size += 1 + term.powers.size();
  }
  return static_cast<std::int64_t>(size);
}

bool RationalFunction::vanishesAtValues() const {
  if (isZero()) return true;
  if (m_ring->values().empty()) return false;
  if (!m_fraction && m_laurent.termCount() == 1) return false;  // ratios are not 0
  return valueOf(quotient().above, m_ring->values()).isZero();
}

RationalFunction::Fraction RationalFunction::asFraction() const {
  return m_fraction ? *m_fraction : Fraction::of(m_laurent, *m_ring);
}

void RationalFunction::setFraction(Fraction fraction) {
  if (auto laurent = fraction.asLaurent()) {
    m_laurent = std::move(*laurent);
    m_fraction.reset();
  } else {
    m_laurent = {};
    m_fraction.reset(new Fraction(std::move(fraction)));
  }
}

void RationalFunction::combine(const RationalFunction& other, bool negated) {
  if (other.isZero()) return;
  if (!m_ring) m_ring = other.m_ring;
  if (!m_fraction && !other.m_fraction &&
      (negated ? m_laurent.subtract(other.m_laurent) : m_laurent.add(other.m_laurent))) {
    return;
  }
  Fraction sum = asFraction();
  sum.add(other.asFraction(), negated);
  setFraction(std::move(sum));
}

void RationalFunction::multiply(const RationalFunction& other, bool inverse) {
  if (!m_fraction && !other.m_fraction && (!inverse || other.m_laurent.isUnit())) {
    LaurentPolynomial result;
    if (inverse ? result.setQuotient(m_laurent, other.m_laurent)
                : result.setProduct(m_laurent, other.m_laurent)) {
      m_laurent = std::move(result);
      return;
    }
  }
  Fraction product = asFraction();
  product.multiply(other.asFraction(), inverse);
  setFraction(std::move(product));
}

RationalFunction& RationalFunction::operator+=(const RationalFunction& other) {
  combine(other, false);
  return *this;
}

RationalFunction& RationalFunction::operator-=(const RationalFunction& other) {
  combine(other, true);
  return *this;
}

RationalFunction& RationalFunction::operator*=(const RationalFunction& other) {
  if (isZero()) return *this;
  if (other.isZero()) return *this = fromInteger(m_ring, 0);
  multiply(other, false);
  return *this;
}

RationalFunction& RationalFunction::operator/=(const RationalFunction& other) {
  GEARGRAPH_REQUIRE(!other.isZero());
  if (!isZero()) multiply(other, true);
  return *this;
}

void RationalFunction::subtractProduct(const RationalFunction& b, const RationalFunction& c) {
  if (b.isZero() || c.isZero()) return;
  if (!m_fraction && !b.m_fraction && !c.m_fraction) {
    LaurentPolynomial product;
    if (product.setProduct(b.m_laurent, c.m_laurent) && m_laurent.subtract(std::move(product))) {
      if (!m_ring) m_ring = b.m_ring;
      return;
    }
  }
  *this -= b * c;
}

RationalFunction operator-(RationalFunction a) {
  if (a.m_fraction) {
    a.m_fraction->negate();
  } else {
    a.m_laurent.negate();
  }
  return a;
}

bool operator==(const RationalFunction& a, const RationalFunction& b) {
  if (!a.m_fraction || !b.m_fraction) return !a.m_fraction && !b.m_fraction && a.m_laurent == b.m_laurent;
  return *a.m_fraction == *b.m_fraction;
}

RationalFunction::Quotient RationalFunction::quotientOfLaurent() const {
  std::map<int, int> below;
  m_laurent.forEachTerm([&](const LaurentPolynomial::Term& term) {
    for (const std::uint32_t power : term.powers) {
      const int exponent = LaurentPolynomial::powerOf(power);
      if (exponent >= 0) continue;
      int& most = below[LaurentPolynomial::ratioOf(power)];
      most = std::max(most, -exponent);
    }
  });
  const auto add = [](Terms& terms, std::int64_t coefficient, const std::map<int, int>& powers) {
    Term& term = terms.emplace_back();
    term.coefficient = coefficient;
    for (const auto& [ratio, power] : powers) {
      if (power != 0) term.powers.emplace_back(ratio, static_cast<unsigned long>(power));
    }
  };
  Quotient result;
  m_laurent.forEachTerm([&](const LaurentPolynomial::Term& term) {
    std::map<int, int> powers = below;
    for (const std::uint32_t power : term.powers) {
      powers[LaurentPolynomial::ratioOf(power)] += LaurentPolynomial::powerOf(power);
    }
    add(result.above, term.coefficient, powers);
  });
  add(result.below, 1, below);
  return result;
}

RationalFunction::Quotient RationalFunction::quotient() const {
  if (!m_fraction) return quotientOfLaurent();
  std::vector<ulong> powers(static_cast<std::size_t>(m_ring->variables()));
  const auto termsOf = [&](const Polynomial& polynomial) {
    Terms terms;
    for (slong i = 0; i < polynomial.length(); ++i) {
      Term& term = terms.emplace_back();
      term.coefficient = polynomial.coefficient(i);
      polynomial.powers(i, powers);
      for (std::size_t ratio = 0; ratio < powers.size(); ++ratio) {
        if (powers[ratio] != 0) term.powers.emplace_back(static_cast<int>(ratio), powers[ratio]);
      }
    }
    return terms;
  };
  return {termsOf(m_fraction->above()), termsOf(m_fraction->below())};
}

Rational RationalFunction::valueOf(const Terms& terms, std::span<const Rational> ratios) {
  Rational sum;
  for (const Term& term : terms) {
    Rational product = term.coefficient;
    for (const auto& [ratio, exponent] : term.powers) {
      Rational power;
      fmpq_pow_si(power.flint(), ratios[static_cast<std::size_t>(ratio)].flint(),
                  static_cast<slong>(exponent));
      product *= power;
    }
    sum += product;
  }
  return sum;
}

std::optional<Rational> RationalFunction::valueAt(std::span<const Rational> ratios) const {
  if (isZero()) return Rational(0);
  GEARGRAPH_REQUIRE(static_cast<int>(ratios.size()) == m_ring->variables());
  const Quotient terms = quotient();
  const Rational below = valueOf(terms.below, ratios);
  if (below.isZero()) return std::nullopt;
  return valueOf(terms.above, ratios) / below;
}

}  // namespace geargraph
