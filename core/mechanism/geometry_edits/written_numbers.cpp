#include "core/mechanism/geometry_edits/written_numbers.h"

#include <cmath>

namespace geargraph {

Rational plainDecimal(double value) {
  constexpr int kParts = 1'000'000;
  const Rational decimal(static_cast<long long>(std::llround(value * kParts)), kParts);
  return std::abs(decimal.toDouble() - value) <= 1e-12 * std::abs(value) ? decimal
                                                                         : Rational::fromDouble(value);
}

NumberTriple numbersOf(const ExactVector3& v) {
  return {Number(v[0]), Number(v[1]), Number(v[2])};
}

}  // namespace geargraph
