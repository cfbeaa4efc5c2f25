#include "core/theory/pose/angle.h"

#include <flint/fmpz.h>

#include <numbers>

namespace geargraph {
namespace {

class BigInteger {
 public:
  BigInteger() { fmpz_init(m_value); }
  BigInteger(const BigInteger&) = delete;
  BigInteger& operator=(const BigInteger&) = delete;
  ~BigInteger() { fmpz_clear(m_value); }
  [[nodiscard]] fmpz* get() { return m_value; }

 private:
  fmpz_t m_value;
};

/// The nearest whole number, of two the lower one.
Rational nearestWhole(const Rational& value) {
  Rational whole = value - Rational(1, 2);
  fmpz_cdiv_q(fmpq_numref(whole.flint()), fmpq_numref(whole.flint()), fmpq_denref(whole.flint()));
  fmpz_one(fmpq_denref(whole.flint()));
  return whole;
}

/// 2^bits * weight * arctan(1 / inverse), by its series.
void addArctangent(fmpz* sum, long weight, ulong inverse, ulong bits) {
  BigInteger power;
  BigInteger term;
  fmpz_set_si(power.get(), weight);
  fmpz_mul_2exp(power.get(), power.get(), bits);
  fmpz_tdiv_q_ui(power.get(), power.get(), inverse);
  for (ulong odd = 1; fmpz_is_zero(power.get()) == 0; odd += 2) {
    fmpz_tdiv_q_ui(term.get(), power.get(), odd);
    if (odd % 4 == 1) {
      fmpz_add(sum, sum, term.get());
    } else {
      fmpz_sub(sum, sum, term.get());
    }
    fmpz_tdiv_q_ui(power.get(), power.get(), inverse * inverse);
  }
}

/// 2 pi, right to `bits` binary places, by Machin: pi = 16 arctan(1/5) - 4 arctan(1/239).
Rational fullTurn(ulong bits) {
  constexpr ulong kGuard = 32;  // bits that the cut series may lose
  Rational turn;
  addArctangent(fmpq_numref(turn.flint()), 32, 5, bits + kGuard);
  addArctangent(fmpq_numref(turn.flint()), -8, 239, bits + kGuard);
  fmpq_div_2exp(turn.flint(), turn.flint(), bits + kGuard);
  return turn;
}

}  // namespace

double reducedAngle(const Rational& turns, const Rational& radians) {
  const Rational part = turns - nearestWhole(turns);
  if (radians.isZero()) return part.toDouble() * 2 * std::numbers::pi;
  constexpr ulong kPlaces = 128;  // a double has 53, and as many again may cancel
  const ulong bits = fmpz_bits(fmpq_numref(radians.flint())) + kPlaces;
  const Rational turn = fullTurn(bits);
  const Rational angle = radians + part * turn;
  return (angle - nearestWhole(angle / turn) * turn).toDouble();
}

}  // namespace geargraph
