#include "core/foundations/base/arithmetic.h"

#include <flint/fmpz.h>

#include <array>
#include <cstdlib>
#include <utility>

namespace geargraph {
namespace {

constexpr int kDeepest = 64;
constexpr long kLargestPower = 1000;
constexpr std::size_t kMaxTextLength = 10'000;
constexpr flint_bitcnt_t kMaxBits = 50'000;

bool isWithinLimit(const Rational& value) {
  return fmpz_bits(fmpq_numref(value.flint())) <= kMaxBits &&
         fmpz_bits(fmpq_denref(value.flint())) <= kMaxBits;
}

bool isDecimalDigit(char c) {
  return c >= '0' && c <= '9';
}

/// Recursive descent: sum = product (+|- product)*, product = power (*|/ power)*, power = [sign] value [^
/// whole].
class Expression {
 public:
  explicit Expression(std::string_view text) : m_text(text) {}

  std::optional<Rational> run() {
    auto value = sum();
    skipBlanks();
    if (m_at != m_text.size()) return std::nullopt;
    return value;
  }

 private:
  using Value = std::optional<Rational>;

  void skipBlanks() {
    while (m_at < m_text.size() && (m_text[m_at] == ' ' || m_text[m_at] == '\t')) ++m_at;
  }

  /// The operator at this place as one of + - * / ^ ( ), without taking it; 0 for none.
  [[nodiscard]] std::pair<char, std::size_t> symbol() {
    skipBlanks();
    constexpr std::array<std::pair<std::string_view, char>, 12> kSymbols = {{{"+", '+'},
                                                                             {"-", '-'},
                                                                             {"\xE2\x88\x92", '-'},
                                                                             {"*", '*'},
                                                                             {"\xC3\x97", '*'},
                                                                             {"\xC2\xB7", '*'},
                                                                             {"\xE2\x8B\x85", '*'},
                                                                             {"/", '/'},
                                                                             {"\xC3\xB7", '/'},
                                                                             {"^", '^'},
                                                                             {"(", '('},
                                                                             {")", ')'}}};
    for (const auto& [written, meaning] : kSymbols) {
      if (m_text.substr(m_at).starts_with(written)) return {meaning, written.size()};
    }
    return {'\0', 0};
  }

  bool take(char wanted) {
    const auto [found, size] = symbol();
    if (found != wanted) return false;
    m_at += size;
    return true;
  }

  Value sum() {
    Value value = product();
    while (value) {
      const bool adds = take('+');
      if (!adds && !take('-')) return value;
      const Value next = product();
      if (!next) return std::nullopt;
      adds ? * value += * next : * value -= *next;
      if (!isWithinLimit(*value)) return std::nullopt;
    }
    return value;
  }

  Value product() {
    Value value = signedPower();
    while (value) {
      const bool multiplies = take('*');
      if (!multiplies && !take('/')) return value;
      const Value next = signedPower();
      if (!next || (!multiplies && next->isZero())) return std::nullopt;
      multiplies ? * value *= * next : * value /= *next;
      if (!isWithinLimit(*value)) return std::nullopt;
    }
    return value;
  }

  Value signedPower() {
    bool isNegative = false;
    while (true) {
      if (take('-')) {
        isNegative = !isNegative;
      } else if (!take('+')) {
        break;
      }
    }
    Value value = power();
    return value && isNegative ? -*value : value;
  }

  Value power() {
    Value base = bracketOrNumber();
    if (!base || !take('^')) return base;
    const bool isInverse = take('-');
    const Value exponent = bracketOrNumber();
    if (!exponent || !exponent->isInteger() || exponent->abs() > Rational(kLargestPower)) return std::nullopt;
    long times = std::labs(static_cast<long>(exponent->toDouble()));
    if (isInverse != (exponent->sign() < 0) && times > 0) {
      if (base->isZero()) return std::nullopt;
      base = base->inverse();
    }
    Rational result(1);
    for (; times > 0; --times) {
      result *= *base;
      if (!isWithinLimit(result)) return std::nullopt;
    }
    return result;
  }

  Value bracketOrNumber() {
    if (!take('(')) return number();
    if (++m_depth > kDeepest) return std::nullopt;
    Value value = sum();
    --m_depth;
    return take(')') ? value : std::nullopt;
  }

  /// Digits with a point and an exponent.
  Value number() {
    skipBlanks();
    const std::size_t from = m_at;
    while (m_at < m_text.size() && (isDecimalDigit(m_text[m_at]) || m_text[m_at] == '.')) ++m_at;
    const bool hasDigits = m_at > from;
    if (hasDigits && m_at < m_text.size() && (m_text[m_at] == 'e' || m_text[m_at] == 'E')) {
      std::size_t end = m_at + 1;
      if (end < m_text.size() && (m_text[end] == '+' || m_text[end] == '-')) ++end;
      const std::size_t digits = end;
      while (end < m_text.size() && isDecimalDigit(m_text[end])) ++end;
      if (end > digits) m_at = end;
    }
    auto value = Rational::fromText(m_text.substr(from, m_at - from));
    return value && isWithinLimit(*value) ? value : std::nullopt;
  }

  std::string_view m_text;
  std::size_t m_at = 0;
  int m_depth = 0;
};

}  // namespace

std::optional<Rational> arithmeticFromText(std::string_view text) {
  if (text.size() > kMaxTextLength) return std::nullopt;
  return Expression(text).run();
}

}  // namespace geargraph
