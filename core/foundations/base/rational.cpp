#include "core/foundations/base/rational.h"

#include <flint/fmpz.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/foundations/base/contract.h"

namespace geargraph {
namespace {

constexpr std::size_t kMaxNumberLength = 4300;
constexpr long kLargestExponent = 4300;

bool isDigit(char c) {
  return c >= '0' && c <= '9';
}

/// Moves `at` behind the digits that stand there and returns how many there were.
std::size_t skipDigits(std::string_view text, std::size_t& at) {
  const std::size_t start = at;
  while (at < text.size() && isDigit(text[at])) ++at;
  return at - start;
}

/// Sets `value` from a text of digits with an optional sign. @pre the text has that form
void setWhole(fmpz_t value, const std::string& digits) {
  fmpz_set_str(value, digits.c_str(), 10);
}

}  // namespace

Rational::Rational(std::int64_t numerator, std::int64_t denominator) : Rational() {
  GEARGRAPH_REQUIRE(denominator != 0);
  fmpz_t n;
  fmpz_t d;
  fmpz_init_set_si(n, numerator);
  fmpz_init_set_si(d, denominator);
  fmpq_set_fmpz_frac(m_value, n, d);
  fmpz_clear(n);
  fmpz_clear(d);
}

std::optional<Rational> Rational::fromText(std::string_view text) {
  if (text.empty() || text.size() > kMaxNumberLength) return std::nullopt;
  std::size_t at = 0;
  const bool negative = text[0] == '-';
  if (text[0] == '-' || text[0] == '+') ++at;

  std::size_t from = at;
  const std::size_t wholeDigits = skipDigits(text, at);
  std::string digits(text.substr(from, wholeDigits));
  std::string denominator;
  long exponent = 0;

  if (at < text.size() && text[at] == '/') {
    from = ++at;
    if (wholeDigits == 0 || skipDigits(text, at) == 0 || at != text.size()) return std::nullopt;
    denominator = text.substr(from);
  } else {
    if (at < text.size() && text[at] == '.') {
      from = ++at;
      const std::size_t decimals = skipDigits(text, at);
      if (decimals == 0) return std::nullopt;
      digits += text.substr(from, decimals);
      exponent = -static_cast<long>(decimals);
    }
    if (digits.empty()) return std::nullopt;
    if (at < text.size() && (text[at] == 'e' || text[at] == 'E')) {
      ++at;
      if (at + 1 < text.size() && text[at] == '+' && isDigit(text[at + 1])) ++at;
      long written = 0;
      const auto [end, error] = std::from_chars(text.data() + at, text.data() + text.size(), written);
      if (error != std::errc{} || std::labs(written) > kLargestExponent) return std::nullopt;
      at = static_cast<std::size_t>(end - text.data());
      exponent += written;
    }
    if (at != text.size()) return std::nullopt;
  }

  Rational result;
  setWhole(fmpq_numref(result.m_value), digits);
  if (!denominator.empty()) setWhole(fmpq_denref(result.m_value), denominator);
  if (fmpz_is_zero(fmpq_denref(result.m_value)) != 0) return std::nullopt;
  if (exponent != 0) {
    fmpz* target = exponent > 0 ? fmpq_numref(result.m_value) : fmpq_denref(result.m_value);
    fmpz_t power;
    fmpz_init(power);
    fmpz_set_ui(power, 10);
    fmpz_pow_ui(power, power, static_cast<ulong>(std::labs(exponent)));
    fmpz_mul(target, target, power);
    fmpz_clear(power);
  }
  fmpq_canonicalise(result.m_value);
  if (negative) fmpq_neg(result.m_value, result.m_value);
  return result;
}

Rational Rational::fromDouble(double value) {
  GEARGRAPH_REQUIRE(std::isfinite(value));
  int exponent = 0;
  const double mantissa = std::frexp(value, &exponent);
  Rational result(static_cast<std::int64_t>(std::ldexp(mantissa, 53)));
  exponent -= 53;
  if (exponent >= 0) {
    fmpq_mul_2exp(result.m_value, result.m_value, static_cast<ulong>(exponent));
  } else {
    fmpq_div_2exp(result.m_value, result.m_value, static_cast<ulong>(-exponent));
  }
  return result;
}

double Rational::toDouble() const {
  // Small fractions by one correctly rounded division; the rest from the first bits of the quotient, the last
  // of which says whether anything follows, so that rounding them is rounding the exact value.
  const fmpz* n = fmpq_numref(m_value);
  const fmpz* d = fmpq_denref(m_value);
  if (fmpz_bits(n) <= 53 && fmpz_bits(d) <= 53) {
    return static_cast<double>(fmpz_get_si(n)) / static_cast<double>(fmpz_get_si(d));
  }
  constexpr slong kMaxPlaces = 1076;  // two more than a subnormal double has behind the point
  const slong places = 55 - static_cast<slong>(fmpz_bits(n)) + static_cast<slong>(fmpz_bits(d));
  const slong shift = std::min(places, kMaxPlaces);
  fmpz_t scaled;
  fmpz_t divisor;
  fmpz_t rest;
  fmpz_init(scaled);
  fmpz_init_set(divisor, d);
  fmpz_init(rest);
  fmpz_abs(scaled, n);
  fmpz* const larger = shift > 0 ? scaled : divisor;
  fmpz_mul_2exp(larger, larger, static_cast<ulong>(std::labs(shift)));
  fmpz_tdiv_qr(scaled, rest, scaled, divisor);
  const ulong bits = fmpz_get_ui(scaled) | (fmpz_is_zero(rest) != 0 ? 0U : 1U);
  fmpz_clear(scaled);
  fmpz_clear(divisor);
  fmpz_clear(rest);
  const int dropped = bits >> 55U != 0 ? 3 : 2;
  const ulong half = 1UL << static_cast<unsigned>(dropped - 1);
  const ulong tail = bits & (2 * half - 1);
  const ulong mantissa = bits >> static_cast<unsigned>(dropped);
  const bool up = tail > half || (tail == half && mantissa % 2 == 1);
  return sign() * std::ldexp(static_cast<double>(mantissa + (up ? 1 : 0)), static_cast<int>(dropped - shift));
}

std::string Rational::toString() const {
  char* text = fmpq_get_str(nullptr, 10, m_value);
  std::string result(text);
  flint_free(text);
  return result;
}

Rational Rational::abs() const {
  Rational result;
  fmpq_abs(result.m_value, m_value);
  return result;
}

Rational Rational::inverse() const {
  GEARGRAPH_REQUIRE(!isZero());
  Rational result;
  fmpq_inv(result.m_value, m_value);
  return result;
}

std::optional<Rational> Rational::squareRoot() const {
  if (sign() < 0) return std::nullopt;
  if (fmpz_is_square(fmpq_numref(m_value)) == 0 || fmpz_is_square(fmpq_denref(m_value)) == 0)
    return std::nullopt;
  Rational root;
  fmpz_sqrt(fmpq_numref(root.m_value), fmpq_numref(m_value));
  fmpz_sqrt(fmpq_denref(root.m_value), fmpq_denref(m_value));
  return root;
}

Rational& Rational::operator/=(const Rational& other) {
  GEARGRAPH_REQUIRE(!other.isZero());
  fmpq_div(m_value, m_value, other.m_value);
  return *this;
}

}  // namespace geargraph
