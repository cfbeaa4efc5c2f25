#include "core/theory/pose/period.h"

namespace geargraph {

std::optional<Rational> commonPeriod(std::span<const Rational> rates) {
  Rational divisor;  // FLINT's gcd of fractions is the largest one that all of them are whole multiples of
  for (const Rational& rate : rates) fmpq_gcd(divisor.flint(), divisor.flint(), rate.flint());
  if (divisor.isZero()) return std::nullopt;
  return divisor.inverse();
}

}  // namespace geargraph
