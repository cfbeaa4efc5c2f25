#include "core/foundations/exact/prime_field.h"

#include <flint/ulong_extras.h>

#include "core/foundations/base/contract.h"

namespace geargraph {
namespace {

/// One step of the splitmix64 generator (Steele, Lea and Flood, 2014).
std::uint64_t mixed(std::uint64_t& state) {
  state += 0x9e3779b97f4a7c15U;
  std::uint64_t z = state;
  z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
  return z ^ (z >> 31U);
}

/// The smallest prime above a number of 61 bits that the seed gives.
std::uint64_t primeOf(std::uint64_t seed) {
  constexpr std::uint64_t kTop = std::uint64_t{1} << 60U;
  const std::uint64_t prime = n_nextprime(kTop + (mixed(seed) & (kTop - 1)), 0);
  return prime >> 61U == 0 ? prime : n_nextprime(kTop, 0);  // over the top of 61 bits: from their bottom
}

}  // namespace

PrimeField::PrimeField(std::uint64_t seed) {
  // The two that every analysis uses are looked for once.
  static const PrimeField first = PrimeField::modulo(primeOf(kFirstSeed));
  static const PrimeField second = PrimeField::modulo(primeOf(kSecondSeed));
  *this = seed == kFirstSeed ? first : seed == kSecondSeed ? second : PrimeField::modulo(primeOf(seed));
}

PrimeField PrimeField::modulo(std::uint64_t prime) {
  PrimeField field(prime, 1);
  for (int i = 0; i < 6; ++i) {  // Newton's doubling of the correct low bits
    field.m_minusInverse *= 2 - prime * field.m_minusInverse;
  }
  field.m_minusInverse = 0 - field.m_minusInverse;
  field.m_one = static_cast<std::uint64_t>((static_cast<Wide>(1) << 64U) % prime);
  field.m_square = static_cast<std::uint64_t>(static_cast<Wide>(field.m_one) * field.m_one % prime);
  return field;
}

PrimeField::Residue PrimeField::inverse(Residue a) const {
  GEARGRAPH_REQUIRE(a != 0);
  return multiply(n_invmod(toNumber(a), m_prime), m_square);
}

std::optional<PrimeField::Residue> PrimeField::fromRational(const Rational& value) const {
  const std::uint64_t denominator = fmpz_fdiv_ui(fmpq_denref(value.flint()), m_prime);
  if (denominator == 0) return std::nullopt;
  const Residue numerator = multiply(fmpz_fdiv_ui(fmpq_numref(value.flint()), m_prime), m_square);
  if (denominator == 1) return numerator;
  return multiply(numerator, inverse(multiply(denominator, m_square)));
}

PrimeField::Residue ResidueStream::next() {
  for (;;) {
    const std::uint64_t residue = mixed(m_state) % m_field->prime();
    if (residue != 0) return residue;
  }
}

}  // namespace geargraph
