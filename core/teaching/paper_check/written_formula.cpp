#include "core/teaching/paper_check/written_formula.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

#include "core/foundations/base/words.h"
#include "core/teaching/grading/number_text.h"

namespace geargraph::inline paper_check {
namespace {

constexpr int kDeepest = 30;
constexpr int kHighestPower = 20;
constexpr std::size_t kLongest = 2'000;
constexpr std::size_t kMostTerms = 500;
constexpr std::int64_t kLargestFunction = 20'000;

bool isDigit(char c) {
  return c >= '0' && c <= '9';
}

/// Reads a name at `at` of a text in plain notation and moves behind it.
std::optional<WrittenName> nameAt(const std::string& text, std::size_t& at) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 10> kBases = {{{"thetadot", "theta"},
                                                                                     {"theta", "theta"},
                                                                                     {"omega", "w"},
                                                                                     {"q", "theta"},
                                                                                     {"w", "w"},
                                                                                     {"i", "i"},
                                                                                     {"n", "n"},
                                                                                     {"N", "N"},
                                                                                     {"z", "N"},
                                                                                     {"d", "d"}}};
  const auto base = std::find_if(kBases.begin(), kBases.end(), [&](const auto& candidate) {
    return std::string_view(text).substr(at).starts_with(candidate.first);
  });
  if (base == kBases.end()) return std::nullopt;
  WrittenName name{std::string(base->second), {}, 0};
  std::size_t end = at + base->first.size();
  const auto primes = [&] {
    const bool isRaised =
        end + 1 < text.size() && text[end] == '^' && (text[end + 1] == '{' || text[end + 1] == '\'');
    const std::size_t begin = end;
    if (isRaised) end += text[end + 1] == '{' ? 2 : 1;
    if (isRaised && (end >= text.size() || text[end] != '\'')) {
      end = begin;
      return;
    }
    for (; end < text.size() && text[end] == '\''; ++end) ++name.primes;
    if (isRaised && end < text.size() && text[end] == '}') ++end;
  };
  primes();
  bool isBraced = false;
  if (end < text.size() && text[end] == '_') {
    ++end;
    isBraced = end < text.size() && text[end] == '{';
    if (isBraced) ++end;
  }
  for (; end < text.size(); ++end) {
    const char c = text[end];
    const bool isMark = (c == '_' || c == ',' || c == ' ') && !name.subscript.empty();
    const bool isInside = isBraced || (c == '_' && end + 1 < text.size() && isDigit(text[end + 1]));
    if (isDigit(c)) {
      name.subscript += c;
    } else if (isMark && isInside) {
      if (name.subscript.back() != '_') name.subscript += '_';
    } else {
      break;
    }
  }
  if (isBraced) {
    if (end >= text.size() || text[end] != '}') return std::nullopt;
    ++end;
  }
  primes();
  if (name.subscript.empty() || name.subscript.back() == '_') return std::nullopt;
  at = end;
  return name;
}

/// Recursive descent over a cell in plain notation.
class FormulaReader {
 public:
  FormulaReader(const Vocabulary& vocabulary, const WrittenCell& cell)
      : m_vocabulary(vocabulary), m_cell(cell), m_text(plainNotation(cell.text)) {}

  Expected<WrittenFormula> read() {
    if (m_text.find_first_not_of(' ') == std::string::npos)
      return fault(translated("An entry is missing here."));
    if (m_text.size() > kLongest) return fault(translated("This formula is too long."));
    WrittenFormula whole = sum(0);
    if (m_fault.empty() && peek() != '\0') fail(unexpected());
    if (!m_fault.empty()) return fault(m_fault);
    return whole;
  }

 private:
  [[nodiscard]] Diagnostic fault(std::string message) const {
    Diagnostic fault{Code::syntax, std::move(message), {}, {}};
    fault.line = m_cell.line;
    fault.column = m_cell.column;
    return fault;
  }
  [[nodiscard]] std::string unexpected() const {
    return translated(
        "“%1” cannot be read: write a number, a fraction or names such as i15, n41, N4, θ8 or "
        "ω51.",
        {m_cell.text});
  }
  void fail(std::string message) {
    if (m_fault.empty()) m_fault = std::move(message);
    m_at = m_text.size();
  }
  char peek() {
    while (m_at < m_text.size() && m_text[m_at] == ' ') ++m_at;
    return m_at < m_text.size() ? m_text[m_at] : '\0';
  }

  [[nodiscard]] WrittenFormula number(const Rational& value, const Rational& slack, bool isMeasured) const {
    WrittenFormula formula;
    formula.amount = {m_vocabulary.constant(value), false, isMeasured, slack};
    return formula;
  }

  WrittenFormula sum(int depth) {
    WrittenFormula whole = product(depth);
    for (char sign = peek(); sign == '+' || sign == '-'; sign = peek()) {
      ++m_at;
      add(whole, product(depth), sign == '-');
    }
    return whole;
  }

  void add(WrittenFormula& whole, const WrittenFormula& part, bool isNegative) {
    const auto join = [&](WrittenAmount& to, const WrittenAmount& amount) {
      isNegative ? to.value -= amount.value : to.value += amount.value;
      to.hasRatios = to.hasRatios || amount.hasRatios;
      to.hasNumbers = to.hasNumbers || amount.hasNumbers;
      to.slack += amount.slack;
    };
    join(whole.amount, part.amount);
    if (whole.terms.size() + part.terms.size() > kMostTerms || whole.amount.value.size() > kLargestFunction)
      return fail(translated("This formula is too long."));
    for (const WrittenFormula::Term& term : part.terms) {
      whole.terms.push_back(term);
      if (isNegative) whole.terms.back().coefficient.value = -term.coefficient.value;
    }
  }

  /// Multiplied by an amount.
  [[nodiscard]] WrittenAmount times(const WrittenAmount& a, const WrittenAmount& b) const {
    Rational slack = 0;
    if (!a.slack.isZero() || !b.slack.isZero()) {
      slack = m_vocabulary.atTeeth(a.value).abs() * b.slack + m_vocabulary.atTeeth(b.value).abs() * a.slack +
              a.slack * b.slack;
    }
    return {a.value * b.value, a.hasRatios || b.hasRatios, a.hasNumbers || b.hasNumbers, slack};
  }
  WrittenFormula times(WrittenFormula a, const WrittenFormula& b) {
    if (!b.terms.empty()) {
      if (!a.terms.empty()) {
        fail(translated("A velocity is multiplied by a velocity here."));
        return a;
      }
      return times(b, a);
    }
    for (WrittenFormula::Term& term : a.terms) term.coefficient = times(term.coefficient, b.amount);
    a.amount = times(a.amount, b.amount);
    if (a.amount.value.size() > kLargestFunction) fail(translated("This formula is too long."));
    return a;
  }
  WrittenFormula inverse(WrittenFormula formula) {
    if (!formula.terms.empty()) {
      fail(translated("Something is divided by a velocity here."));
      return formula;
    }
    if (formula.amount.value.isZero()) {
      fail(translated("Something is divided by 0 here."));
      return formula;
    }
    const Rational size = m_vocabulary.atTeeth(formula.amount.value);
    if (!size.isZero()) formula.amount.slack /= size * size;
    formula.amount.value = m_vocabulary.constant(1) / formula.amount.value;
    return formula;
  }

  WrittenFormula product(int depth) {
    WrittenFormula whole = factor(depth);
    for (char c = peek(); c != '\0' && m_fault.empty(); c = peek()) {
      if (c == '*' || c == '/') {
        ++m_at;
        const WrittenFormula next = factor(depth);
        if (m_fault.empty()) whole = times(std::move(whole), c == '*' ? next : inverse(next));
      } else if (startsFactor(c)) {
        whole = times(std::move(whole), factor(depth));
      } else {
        break;
      }
    }
    return whole;
  }
  static bool startsFactor(char c) {
    return c == '(' || c == '{' || c == '[' || c == '\\' || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
  }

  WrittenFormula factor(int depth) {
    if (depth > kDeepest) fail(translated("This formula has too many parentheses inside each other."));
    if (!m_fault.empty()) return {};
    const char c = peek();
    if (c == '-' || c == '+') {
      ++m_at;
      return times(factor(depth + 1), number(c == '-' ? -1 : 1, 0, false));
    }
    WrittenFormula base = c == '(' || c == '{' || c == '[' ? group(depth)
                          : isDigit(c) || c == '.'         ? literal()
                                                           : named(depth);
    if (m_fault.empty() && peek() == '^') {
      ++m_at;
      return power(base);
    }
    return base;
  }

  WrittenFormula group(int depth) {
    const char open = peek();
    const char close = open == '(' ? ')' : open == '{' ? '}' : ']';
    ++m_at;
    WrittenFormula inner = sum(depth + 1);
    if (m_fault.empty() && peek() != close) fail(unexpected());
    ++m_at;
    return inner;
  }

  WrittenFormula power(const WrittenFormula& base) {
    const bool isBraced = peek() == '{' || peek() == '(';
    if (isBraced) ++m_at;
    const bool isNegative = peek() == '-';
    if (isNegative) ++m_at;
    int exponent = 0;
    const char* const begin = m_text.data() + m_at;
    const auto [end, error] = std::from_chars(begin, m_text.data() + m_text.size(), exponent);
    if (error != std::errc() || exponent > kHighestPower) {
      fail(translated("A power needs a whole number of at most %1.", {std::to_string(kHighestPower)}));
      return {};
    }
    m_at += static_cast<std::size_t>(end - begin);
    if (isBraced) ++m_at;
    WrittenFormula whole = number(1, 0, false);
    for (int i = 0; i < exponent && m_fault.empty(); ++i) whole = times(std::move(whole), base);
    return isNegative ? inverse(std::move(whole)) : whole;
  }

  WrittenFormula literal() {
    const std::size_t begin = m_at;
    while (m_at < m_text.size() && (isDigit(m_text[m_at]) || m_text[m_at] == '.' || m_text[m_at] == ','))
      ++m_at;
    const std::string digits = m_text.substr(begin, m_at - begin);
    const WrittenNumber read = readNumber(digits);
    if (read.fault == NumberFault::ambiguous) {
      fail(translated("“%1” can be read as a thousand or as a decimal: write it without the comma.",
                      {digits}));
    } else if (read.fault == NumberFault::notANumber) {
      fail(translated("“%1” is not a number.", {digits}));
    } else {
      return number(read.value, read.slack, !(read.value.isZero() || read.value == Rational(1)));
    }
    return {};
  }

  WrittenFormula named(int depth) {
    if (std::string_view(m_text).substr(m_at).starts_with("\\frac")) {
      m_at += 5;
      WrittenFormula above = fractionPart(depth);
      WrittenFormula below = fractionPart(depth);
      if (!m_fault.empty()) return {};
      return times(std::move(above), inverse(std::move(below)));
    }
    const auto name = nameAt(m_text, m_at);
    if (!name) {
      fail(unexpected());
      return {};
    }
    std::string why;
    WrittenFormula formula;
    if (Vocabulary::isRate(*name)) {
      const auto rates = m_vocabulary.rate(*name, why);
      if (!rates) fail(why);
      formula.amount.value = m_vocabulary.constant(0);
      if (rates) formula.terms.push_back({*name, *rates, {m_vocabulary.constant(1), false, false, 0}});
      return formula;
    }
    const auto value = m_vocabulary.value(*name, why);
    if (!value) {
      fail(why);
      return formula;
    }
    formula.amount = {value->value, value->isRatio, !value->isRatio, 0};
    return formula;
  }

  /// "{...}", or one digit as in \frac12.
  WrittenFormula fractionPart(int depth) {
    const char c = peek();
    if (c == '{') return group(depth);
    if (isDigit(c)) {
      const int digit = m_text[m_at++] - '0';
      return number(digit, 0, digit > 1);
    }
    fail(unexpected());
    return {};
  }

  const Vocabulary& m_vocabulary;
  const WrittenCell& m_cell;
  std::string m_text;
  std::size_t m_at = 0;
  std::string m_fault;
};

}  // namespace

std::string plainNotation(std::string_view text) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 49> kSigns = {{
      {"\\dot{\\theta}", "theta"},
      {"\\dot\\theta", "theta"},
      {"\\theta", "theta"},
      {"\u03b8\u0307", "theta"},
      {"\u03b8", "theta"},
      {"\\omega", "w"},
      {"\u03c9", "w"},
      {"\\cdot", "*"},
      {"\\times", "*"},
      {"\u00b7", "*"},
      {"\u22c5", "*"},
      {"\u00d7", "*"},
      {"\u2212", "-"},
      {"\u2013", "-"},
      {"\u00f7", "/"},
      {"\u2044", "/"},
      {"\\left", ""},
      {"\\right", ""},
      {"\\dfrac", "\\frac"},
      {"\\tfrac", "\\frac"},
      {"\\prime", "'"},
      {"\u2032", "'"},
      {"\u2033", "''"},
      {"\u2034", "'''"},
      {"\\,", " "},
      {"\\;", " "},
      {"\\:", " "},
      {"\\!", ""},
      {"\\ ", " "},
      {"~", " "},
      {"{,}", "."},
      {"\u00a0", " "},
      {"\u202f", " "},
      {"\t", " "},
      {"\u2080", "0"},
      {"\u2081", "1"},
      {"\u2082", "2"},
      {"\u2083", "3"},
      {"\u2084", "4"},
      {"\u2085", "5"},
      {"\u2086", "6"},
      {"\u2087", "7"},
      {"\u2088", "8"},
      {"\u2089", "9"},
      {"\\mathrm", ""},
      {"\\displaystyle", ""},
      {"$", ""},
      {"\\quad", " "},
      {".*", "*"},
  }};
  std::string plain;
  for (std::size_t at = 0; at < text.size();) {
    const auto sign = std::find_if(kSigns.begin(), kSigns.end(),
                                   [&](const auto& s) { return text.substr(at).starts_with(s.first); });
    if (sign == kSigns.end()) {
      plain += text[at++];
    } else {
      plain += sign->second;
      at += sign->first.size();
    }
  }
  return plain;
}

std::optional<WrittenName> readName(const std::string& text) {
  const std::string plain = plainNotation(text);
  std::size_t at = std::min(plain.find_first_not_of(' '), plain.size());
  auto name = nameAt(plain, at);
  if (!name || plain.find_first_not_of(' ', at) != std::string::npos) return std::nullopt;
  return name;
}

Expected<WrittenFormula> readFormula(const Vocabulary& vocabulary, const WrittenCell& cell) {
  return FormulaReader(vocabulary, cell).read();
}

Expected<WrittenAmount> readAmount(const Vocabulary& vocabulary, const WrittenCell& cell) {
  auto formula = readFormula(vocabulary, cell);
  if (!formula) return formula.error();
  if (!formula->terms.empty()) {
    Diagnostic fault{Code::syntax,
                     translated("“%1” holds a velocity, and an entry of a matrix is a number.", {cell.text}),
                     {},
                     {}};
    fault.line = cell.line;
    fault.column = cell.column;
    return fault;
  }
  return formula->amount;
}

}  // namespace geargraph::inline paper_check
