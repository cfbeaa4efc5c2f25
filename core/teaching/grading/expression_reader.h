#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "core/foundations/base/rational.h"
#include "core/teaching/grading/written_name.h"

namespace geargraph {

/// Is a comma before three digits a decimal sign, as in "1,250"? Where it is not, such a number is ambiguous.
enum class CommaUse { ambiguous, decimal };

enum class ExpressionFault { none, missing, unexpected, ambiguous, notANumber, tooDeep, power, meaning };

/// Where reading stopped, and why.
struct ExpressionStop {
  ExpressionFault fault = ExpressionFault::none;
  std::string text;  ///< the number that is meant, else the rest of the text in plain notation
};

/// Parses sums, products, quotients and whole powers of numbers and symbols in plain notation
/// (plainNotation()): the only grammar of answers and papers. Numbers are whole or decimals, with an exponent
/// ("2.5e-3") and per cent; products may leave the sign out ("2(i15 - 1)", "i18 i17").
///
/// `Domain` says what numbers and symbols are worth: a type `Value` with constant(value, slack),
/// add(sum, part, isNegative), multiply(a, b), inverse(value) and named(name). Where one of these has no
/// result it sets failed(). Cost: linear in the text, times that of the domain.
template <class Domain>
class ExpressionReader {
 public:
  using Value = typename Domain::Value;

  static constexpr int kDeepest = 30;  ///< parentheses inside each other
  static constexpr int kHighestPower = 20;
  static constexpr int kHighestExponent = 99;

  ExpressionReader(Domain& domain, std::string plain, CommaUse comma)
      : m_domain(domain), m_text(std::move(plain)), m_comma(comma) {}

  /// The whole text. Of no use unless stop().fault is none.
  Value read() {
    if (m_text.find_first_not_of(' ') == std::string::npos) {
      fail(ExpressionFault::missing, "");
      return m_domain.constant(0, 0);
    }
    Value whole = sum(0);
    if (peek() != '\0') unexpected();
    return whole;
  }
  [[nodiscard]] const ExpressionStop& stop() const { return m_stop; }

 private:
  static bool isDigit(char c) { return c >= '0' && c <= '9'; }
  static bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
  static bool opens(char c) { return c == '(' || c == '{' || c == '['; }

  [[nodiscard]] bool isFine() const { return m_stop.fault == ExpressionFault::none; }
  void fail(ExpressionFault fault, std::string text) {
    if (isFine()) m_stop = {fault, std::move(text)};
    m_at = m_text.size();
  }
  void unexpected() { fail(ExpressionFault::unexpected, m_text.substr(std::min(m_at, m_text.size()))); }
  /// The value unless the domain has none; then reading stops at `from`.
  Value checked(Value value, std::size_t from) {
    if (m_domain.failed() && isFine()) fail(ExpressionFault::meaning, m_text.substr(from));
    return value;
  }
  /// The next character that is no blank; 0 at the end.
  char peek() {
    while (m_at < m_text.size() && m_text[m_at] == ' ') ++m_at;
    return m_at < m_text.size() ? m_text[m_at] : '\0';
  }
  [[nodiscard]] char here() const { return m_at < m_text.size() ? m_text[m_at] : '\0'; }

  Value sum(int depth) {
    Value whole = product(depth);
    for (char sign = peek(); sign == '+' || sign == '-'; sign = peek()) {
      const std::size_t from = m_at++;
      Value next = product(depth);
      if (isFine()) whole = checked(m_domain.add(std::move(whole), next, sign == '-'), from);
    }
    return whole;
  }

  Value product(int depth) {
    Value whole = factor(depth);
    for (char c = peek(); c != '\0' && isFine(); c = peek()) {
      const std::size_t from = m_at;
      const bool isDivided = c == '/' || c == ':';
      if (c == '*' || isDivided) {
        ++m_at;
      } else if (!opens(c) && c != '\\' && !isLetter(c)) {
        break;
      }
      Value next = factor(depth);
      if (isFine() && isDivided) next = checked(m_domain.inverse(std::move(next)), from);
      if (isFine()) whole = checked(m_domain.multiply(std::move(whole), next), from);
    }
    return whole;
  }

  Value factor(int depth) {
    const char c = peek();
    if (depth > kDeepest) fail(ExpressionFault::tooDeep, m_text.substr(m_at));
    if (!isFine()) return m_domain.constant(0, 0);
    const std::size_t from = m_at;
    if (c == '-' || c == '+') {
      ++m_at;
      Value value = factor(depth + 1);
      return isFine() ? m_domain.multiply(std::move(value), m_domain.constant(c == '-' ? -1 : 1, 0)) : value;
    }
    Value base = opens(c) ? group(depth) : isDigit(c) || c == '.' || c == ',' ? literal() : named(depth);
    if (isFine() && peek() == '^') {
      ++m_at;
      base = power(base, from);
    }
    for (; isFine() && peek() == '%'; ++m_at)
      base = checked(m_domain.multiply(std::move(base), m_domain.constant(Rational(1, 100), 0)), from);
    return base;
  }

  Value group(int depth) {
    const char open = peek();
    const char close = open == '(' ? ')' : open == '{' ? '}' : ']';
    ++m_at;
    Value inner = sum(depth + 1);
    if (isFine() && peek() != close) unexpected();
    ++m_at;
    return inner;
  }

  Value power(const Value& base, std::size_t from) {
    const char open = peek();
    const bool isBraced = open == '{' || open == '(';
    if (isBraced) ++m_at;
    const bool isNegative = peek() == '-';
    if (isNegative) ++m_at;
    int exponent = 0;
    const std::size_t begin = m_at;
    for (; isDigit(here()) && exponent <= kHighestPower; ++m_at) exponent = 10 * exponent + (here() - '0');
    Value whole = m_domain.constant(1, 0);
    if (m_at == begin || exponent > kHighestPower) {
      fail(ExpressionFault::power, m_text.substr(from));
      return whole;
    }
    if (isBraced && here() != (open == '{' ? '}' : ')')) unexpected();
    if (isBraced) ++m_at;
    for (int i = 0; i < exponent && isFine(); ++i)
      whole = checked(m_domain.multiply(std::move(whole), base), from);
    if (isFine() && isNegative) whole = checked(m_domain.inverse(std::move(whole)), from);
    return whole;
  }

  std::string digits() {
    std::string all;
    for (; isDigit(here()); ++m_at) all += here();
    return all;
  }

  /// "e-3" after a number; 0 without one, std::nullopt if it is out of range.
  std::optional<int> exponent() {
    const char sign = m_at + 1 < m_text.size() ? m_text[m_at + 1] : '\0';
    const std::size_t first = m_at + (sign == '-' || sign == '+' ? 2 : 1);
    if ((here() != 'e' && here() != 'E') || first >= m_text.size() || !isDigit(m_text[first])) return 0;
    m_at = first;
    int size = 0;
    for (; isDigit(here()); ++m_at) size = std::min(10 * size + (here() - '0'), kHighestExponent + 1);
    if (size > kHighestExponent) return std::nullopt;
    return sign == '-' ? -size : size;
  }

  /// A decimal of at least three significant digits may be rounded or cut off, and may be right to more
  /// digits than were asked for: it stands for everything nearer than one unit of its last place, or nearer
  /// than a two-thousandth of itself.
  Value literal() {
    constexpr std::size_t kMinDigits = 3;
    const std::size_t begin = m_at;
    const std::string whole = digits();
    std::string places;
    const char mark = here();
    const auto failHere = [&](ExpressionFault fault) {
      while (isDigit(here()) || here() == '.' || here() == ',') ++m_at;
      fail(fault, m_text.substr(begin, m_at - begin));
      return m_domain.constant(0, 0);
    };
    if (mark == '.' || mark == ',') {
      ++m_at;
      places = digits();
      const bool isGrouped = mark == ',' && m_comma == CommaUse::ambiguous && places.size() == 3 &&
                             !whole.empty() && whole.size() <= 3 && whole.front() != '0';
      if (here() == '.' || here() == ',' || isGrouped) return failHere(ExpressionFault::ambiguous);
      if (places.empty()) return failHere(ExpressionFault::notANumber);
    }
    const std::string all = whole + places;
    const std::size_t zeros = std::min(all.find_first_not_of('0'), all.size());
    const auto power = exponent();
    if (!power) return failHere(ExpressionFault::notANumber);
    Rational unit = 1;
    for (int i = static_cast<int>(places.size()); i > *power; --i) unit /= 10;
    for (int i = static_cast<int>(places.size()); i < *power; ++i) unit *= 10;
    const Rational value = *Rational::fromText(all.substr(std::min(zeros, all.size() - 1))) * unit;
    const bool isRounded = !places.empty() && all.size() - zeros >= kMinDigits;
    return m_domain.constant(value, isRounded ? std::max(unit, value / 2'000) : Rational(0));
  }

  Value named(int depth) {
    if (std::string_view(m_text).substr(m_at).starts_with("\\frac")) {
      const std::size_t from = m_at;
      m_at += 5;
      Value above = fractionPart(depth);
      Value below = fractionPart(depth);
      if (!isFine()) return above;
      below = checked(m_domain.inverse(std::move(below)), from);
      return isFine() ? checked(m_domain.multiply(std::move(above), below), from) : above;
    }
    const std::size_t from = m_at;
    const auto name = nameAt(m_text, m_at);
    if (!name) {
      unexpected();
      return m_domain.constant(0, 0);
    }
    return checked(m_domain.named(*name), from);
  }

  /// "{...}", or one digit as in \frac12.
  Value fractionPart(int depth) {
    const char c = peek();
    if (c == '{') return group(depth);
    if (isDigit(c)) return m_domain.constant(m_text[m_at++] - '0', 0);
    unexpected();
    return m_domain.constant(0, 0);
  }

  Domain& m_domain;
  std::string m_text;
  CommaUse m_comma;
  std::size_t m_at = 0;
  ExpressionStop m_stop;
};

}  // namespace geargraph
