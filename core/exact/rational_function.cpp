#include "core/exact/rational_function.h"

#include <utility>

#include "core/base/contract.h"

namespace geargraph {
namespace {

/// Owns a polynomial for the length of a computation.
class Polynomial {
 public:
  explicit Polynomial(const RatioRing& ring) : m_context(ring.context()) {
    fmpz_mpoly_init(m_value, m_context);
  }
  Polynomial(const Polynomial&) = delete;
  Polynomial& operator=(const Polynomial&) = delete;
  ~Polynomial() { fmpz_mpoly_clear(m_value, m_context); }
  operator fmpz_mpoly_struct*() { return m_value; }  // NOLINT(google-explicit-constructor)

 private:
  fmpz_mpoly_ctx_struct* m_context;
  fmpz_mpoly_t m_value;
};

/// a and b without their greatest common divisor. Where FLINT finds none (exponents too large for it) they
/// stay, which is right too, only longer.
void cancel(fmpz_mpoly_struct* a, fmpz_mpoly_struct* b, const RatioRing& ring) {
  if (fmpz_mpoly_is_one(b, ring.context()) != 0 || fmpz_mpoly_is_one(a, ring.context()) != 0) return;
  Polynomial divisor(ring);
  Polynomial left(ring);
  Polynomial right(ring);
  if (fmpz_mpoly_gcd_cofactors(divisor, left, right, a, b, ring.context()) == 0) return;
  fmpz_mpoly_swap(a, left, ring.context());
  fmpz_mpoly_swap(b, right, ring.context());
}

/// The value of a polynomial at these ratios.
Rational valueOf(const fmpz_mpoly_t polynomial, const RatioRing& ring, std::span<const Rational> ratios) {
  Rational sum;
  std::vector<ulong> exponents(static_cast<std::size_t>(ring.variables()));
  for (slong term = 0; term < fmpz_mpoly_length(polynomial, ring.context()); ++term) {
    Rational product;
    fmpz_mpoly_get_term_coeff_fmpz(fmpq_numref(product.flint()), polynomial, term, ring.context());
    fmpz_mpoly_get_term_exp_ui(exponents.data(), polynomial, term, ring.context());
    for (std::size_t i = 0; i < exponents.size(); ++i) {
      if (exponents[i] == 0) continue;
      Rational power;
      fmpq_pow_si(power.flint(), ratios[i].flint(), static_cast<slong>(exponents[i]));
      product *= power;
    }
    sum += product;
  }
  return sum;
}

}  // namespace

RatioRing::RatioRing(std::vector<std::string> names, std::vector<Rational> values)
    : m_names(std::move(names)), m_values(std::move(values)) {
  GEARGRAPH_REQUIRE(m_values.empty() || m_values.size() == m_names.size());
  fmpz_mpoly_ctx_init(m_context, static_cast<slong>(m_names.size()), ORD_LEX);
}

RatioRing::~RatioRing() {
  fmpz_mpoly_ctx_clear(m_context);
}

RationalFunction::RationalFunction(RatioRingPtr ring) : m_ring(std::move(ring)) {
  fmpz_mpoly_init(m_numerator, m_ring->context());
  fmpz_mpoly_init(m_denominator, m_ring->context());
  fmpz_mpoly_one(m_denominator, m_ring->context());
}

RationalFunction::RationalFunction(const RationalFunction& other) : m_ring(other.m_ring) {
  if (!m_ring) return;
  fmpz_mpoly_init(m_numerator, m_ring->context());
  fmpz_mpoly_init(m_denominator, m_ring->context());
  fmpz_mpoly_set(m_numerator, other.m_numerator, m_ring->context());
  fmpz_mpoly_set(m_denominator, other.m_denominator, m_ring->context());
}

RationalFunction::RationalFunction(RationalFunction&& other) noexcept {
  swap(other);
}

RationalFunction& RationalFunction::operator=(const RationalFunction& other) {
  if (this != &other) {
    RationalFunction copy(other);
    swap(copy);
  }
  return *this;
}

RationalFunction& RationalFunction::operator=(RationalFunction&& other) noexcept {
  swap(other);
  return *this;
}

RationalFunction::~RationalFunction() {
  if (!m_ring) return;
  fmpz_mpoly_clear(m_numerator, m_ring->context());
  fmpz_mpoly_clear(m_denominator, m_ring->context());
}

void RationalFunction::swap(RationalFunction& other) noexcept {
  std::swap(m_ring, other.m_ring);
  std::swap(m_numerator[0], other.m_numerator[0]);
  std::swap(m_denominator[0], other.m_denominator[0]);
}

RationalFunction RationalFunction::fromInteger(RatioRingPtr ring, std::int64_t value) {
  RationalFunction result(std::move(ring));
  fmpz_mpoly_set_si(result.m_numerator, value, result.m_ring->context());
  return result;
}

RationalFunction RationalFunction::variable(const RatioRingPtr& ring, int variable) {
  RationalFunction result(ring);
  fmpz_mpoly_gen(result.m_numerator, variable, ring->context());
  return result;
}

std::int64_t RationalFunction::termCount() const {
  if (!m_ring) return 1;
  return fmpz_mpoly_length(m_numerator, m_ring->context()) +
         fmpz_mpoly_length(m_denominator, m_ring->context());
}

bool RationalFunction::vanishesAtValues() const {
  if (isZero()) return true;
  if (m_ring->values().empty()) return false;
  if (fmpz_mpoly_length(m_numerator, m_ring->context()) == 1) return false;  // ratios are not 0
  return valueOf(m_numerator, *m_ring, m_ring->values()).isZero();
}

void RationalFunction::normaliseSign() {
  Rational leading;
  fmpz_mpoly_get_term_coeff_fmpz(fmpq_numref(leading.flint()), m_denominator, 0, m_ring->context());
  if (leading.sign() > 0) return;
  fmpz_mpoly_neg(m_numerator, m_numerator, m_ring->context());
  fmpz_mpoly_neg(m_denominator, m_denominator, m_ring->context());
}

void RationalFunction::add(const RationalFunction& other, bool negated) {
  if (other.isZero()) return;
  if (!m_ring) *this = fromInteger(other.m_ring, 0);
  fmpz_mpoly_ctx_struct* context = m_ring->context();
  const auto combine = negated ? fmpz_mpoly_sub : fmpz_mpoly_add;
  if (fmpz_mpoly_equal(m_denominator, other.m_denominator, context) != 0) {
    combine(m_numerator, m_numerator, other.m_numerator, context);
  } else {
    Polynomial mine(*m_ring);
    Polynomial theirs(*m_ring);
    fmpz_mpoly_mul(mine, m_numerator, other.m_denominator, context);
    fmpz_mpoly_mul(theirs, other.m_numerator, m_denominator, context);
    combine(m_numerator, mine, theirs, context);
    fmpz_mpoly_mul(m_denominator, m_denominator, other.m_denominator, context);
  }
  if (isZero()) {
    fmpz_mpoly_one(m_denominator, context);
  } else {
    cancel(m_numerator, m_denominator, *m_ring);
    normaliseSign();
  }
}

RationalFunction& RationalFunction::operator+=(const RationalFunction& other) {
  add(other, false);
  return *this;
}

RationalFunction& RationalFunction::operator-=(const RationalFunction& other) {
  add(other, true);
  return *this;
}

void RationalFunction::multiply(const fmpz_mpoly_t numerator, const fmpz_mpoly_t denominator) {
  fmpz_mpoly_ctx_struct* context = m_ring->context();
  Polynomial above(*m_ring);
  Polynomial below(*m_ring);
  fmpz_mpoly_set(above, numerator, context);
  fmpz_mpoly_set(below, denominator, context);
  cancel(m_numerator, below, *m_ring);  // across: each side is in lowest terms already
  cancel(above, m_denominator, *m_ring);
  fmpz_mpoly_mul(m_numerator, m_numerator, above, context);
  fmpz_mpoly_mul(m_denominator, m_denominator, below, context);
  normaliseSign();
}

RationalFunction& RationalFunction::operator*=(const RationalFunction& other) {
  if (isZero()) return *this;
  if (other.isZero()) return *this = fromInteger(m_ring, 0);
  multiply(other.m_numerator, other.m_denominator);
  return *this;
}

RationalFunction& RationalFunction::operator/=(const RationalFunction& other) {
  GEARGRAPH_REQUIRE(!other.isZero());
  if (!isZero()) multiply(other.m_denominator, other.m_numerator);
  return *this;
}

RationalFunction operator-(RationalFunction a) {
  if (a.m_ring) fmpz_mpoly_neg(a.m_numerator, a.m_numerator, a.m_ring->context());
  return a;
}

bool operator==(const RationalFunction& a, const RationalFunction& b) {
  if (a.isZero() || b.isZero()) return a.isZero() && b.isZero();
  return fmpz_mpoly_equal(a.m_numerator, b.m_numerator, a.m_ring->context()) != 0 &&
         fmpz_mpoly_equal(a.m_denominator, b.m_denominator, a.m_ring->context()) != 0;
}

std::optional<Rational> RationalFunction::valueAt(std::span<const Rational> ratios) const {
  if (isZero()) return Rational(0);
  GEARGRAPH_REQUIRE(static_cast<int>(ratios.size()) == m_ring->variables());
  const Rational below = valueOf(m_denominator, *m_ring, ratios);
  if (below.isZero()) return std::nullopt;
  return valueOf(m_numerator, *m_ring, ratios) / below;
}

}  // namespace geargraph
