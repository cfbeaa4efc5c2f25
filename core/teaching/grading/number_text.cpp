#include "core/teaching/grading/number_text.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace geargraph::inline grading {
namespace {

constexpr std::size_t kLongest = 200;
constexpr int kDeepest = 20;

/// The signs of print in ASCII, without blanks at the ends.
std::string inAscii(std::string_view text) {
  constexpr std::array<std::pair<std::string_view, char>, 9> kSigns = {{{"\u2212", '-'},
                                                                        {"\u2013", '-'},
                                                                        {"\u00d7", '*'},
                                                                        {"\u00b7", '*'},
                                                                        {"\u22c5", '*'},
                                                                        {"\u00f7", '/'},
                                                                        {"\u2044", '/'},
                                                                        {"\u00a0", ' '},
                                                                        {"\u202f", ' '}}};
  std::string ascii;
  for (std::size_t at = 0; at < text.size();) {
    const auto sign = std::find_if(kSigns.begin(), kSigns.end(),
                                   [&](const auto& s) { return text.substr(at).starts_with(s.first); });
    ascii += sign != kSigns.end() ? sign->second : text[at] == ':' ? '/' : text[at];
    at += sign != kSigns.end() ? sign->first.size() : 1;
  }
  const auto isBlank = [](char c) { return c == ' ' || c == '\t'; };
  while (!ascii.empty() && isBlank(ascii.back())) ascii.pop_back();
  ascii.erase(ascii.begin(), std::find_if_not(ascii.begin(), ascii.end(), isBlank));
  return ascii;
}

bool isDigit(char c) {
  return c >= '0' && c <= '9';
}

/// Recursive descent over sums, products and factors.
class NumberReader {
 public:
  explicit NumberReader(std::string text) : m_text(std::move(text)) {}

  WrittenNumber read() {
    WrittenNumber number;
    if (m_text.empty() || m_text.size() > kLongest) return {NumberFault::notANumber, {}, {}};
    number.value = sum(0);
    if (m_at != m_text.size()) fail(NumberFault::notANumber);
    number.fault = m_fault;
    if (m_fault == NumberFault::none && m_literals == 1 && m_isPlain && m_decimals > 0 &&
        m_significant >= 3) {
      number.slack = 1;
      for (int i = 0; i < m_decimals; ++i) number.slack /= 10;
    }
    return number;
  }

 private:
  void fail(NumberFault fault) {
    if (m_fault == NumberFault::none) m_fault = fault;
    m_at = m_text.size();
  }
  /// The next character that is no blank; 0 at the end.
  char peek() {
    while (m_at < m_text.size() && m_text[m_at] == ' ') ++m_at;
    return m_at < m_text.size() ? m_text[m_at] : '\0';
  }

  Rational sum(int depth) {
    Rational value = product(depth);
    for (char sign = peek(); sign == '+' || sign == '-'; sign = peek()) {
      ++m_at;
      m_isPlain = false;
      const Rational next = product(depth);
      sign == '+' ? value += next : value -= next;
    }
    return value;
  }

  Rational product(int depth) {
    Rational value = factor(depth);
    for (char sign = peek(); sign == '*' || sign == '/'; sign = peek()) {
      ++m_at;
      m_isPlain = false;
      const Rational next = factor(depth);
      if (sign == '*') {
        value *= next;
      } else if (next.isZero()) {
        fail(NumberFault::notANumber);
      } else {
        value /= next;
      }
    }
    return value;
  }

  Rational factor(int depth) {
    const char c = peek();
    if (depth > kDeepest) fail(NumberFault::notANumber);
    if (c == '-' || c == '+') {
      ++m_at;
      const Rational value = factor(depth + 1);
      return c == '-' ? -value : value;
    }
    if (c == '(') {
      ++m_at;
      Rational value = sum(depth + 1);
      if (peek() != ')') {
        fail(NumberFault::notANumber);
      } else {
        ++m_at;
      }
      return value;
    }
    return literal();
  }

  Rational literal() {
    const std::size_t begin = m_at;
    std::string digits;
    std::string places;
    while (m_at < m_text.size() && isDigit(m_text[m_at])) digits += m_text[m_at++];
    const char mark = m_at < m_text.size() ? m_text[m_at] : '\0';
    if (mark == '.' || mark == ',') {
      ++m_at;
      while (m_at < m_text.size() && isDigit(m_text[m_at])) places += m_text[m_at++];
      const char next = m_at < m_text.size() ? m_text[m_at] : '\0';
      const bool isGrouped = digits.size() <= 3 && !digits.empty() && digits.front() != '0';
      if (next == '.' || next == ',' || (mark == ',' && places.size() == 3 && isGrouped)) {
        fail(NumberFault::ambiguous);
        return {};
      }
      if (places.empty()) fail(NumberFault::notANumber);
    }
    if (m_at == begin || (digits.empty() && places.empty())) {
      fail(NumberFault::notANumber);
      return {};
    }
    const std::string all = digits + places;
    ++m_literals;
    m_decimals = static_cast<int>(places.size());
    m_significant = static_cast<int>(all.size() - std::min(all.find_first_not_of('0'), all.size()));
    Rational value = *Rational::fromText(all.substr(std::min(all.find_first_not_of('0'), all.size() - 1)));
    for (std::size_t i = 0; i < places.size(); ++i) value /= 10;
    return value;
  }

  std::string m_text;
  std::size_t m_at = 0;
  NumberFault m_fault = NumberFault::none;
  int m_literals = 0;
  bool m_isPlain = true;  ///< one literal with signs and parentheses
  int m_decimals = 0;     ///< of the last literal
  int m_significant = 0;
};

}  // namespace

WrittenNumber readNumber(std::string_view text) {
  return NumberReader(inAscii(text)).read();
}

}  // namespace geargraph::inline grading
