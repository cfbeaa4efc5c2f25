#pragma once

#include "core/foundations/exact/prime_field.h"

namespace geargraph {

/// Numbers modulo a 61-bit prime for the elimination (exact/fields.h).
class ResidueField {
 public:
  using Value = PrimeField::Residue;
  using Sum = Value;

  [[nodiscard]] const PrimeField& prime() const { return m_prime; }
  [[nodiscard]] Value one() const { return m_prime.one(); }
  [[nodiscard]] Value fromInteger(std::int64_t value) const { return m_prime.fromInteger(value); }
  [[nodiscard]] bool isZero(Value value) const { return value == 0; }
  void subtract(Value& a, Value b) const { a = m_prime.subtract(a, b); }
  void subtractProduct(Value& a, Value b, Value c) const { a = m_prime.subtract(a, m_prime.multiply(b, c)); }
  [[nodiscard]] Value quotient(Value a, Value b) const { return m_prime.multiply(a, m_prime.inverse(b)); }
  [[nodiscard]] const Value& divisor(const Value& value) const { return value; }
  [[nodiscard]] Value negated(Value a) const { return m_prime.negate(a); }
  [[nodiscard]] double pivotWeight(Value value) const { return value == 0 ? 0 : 1; }

 private:
  PrimeField m_prime;
};

}  // namespace geargraph
