#include "core/teaching/grading/number_text.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "core/foundations/base/locale.h"

namespace geargraph {
namespace {

constexpr std::size_t kMaxLength = 200;
constexpr std::size_t kMaxDigits = 1'000;  ///< of numerator and denominator

struct Amount {
  Rational value;
  Rational slack;
};

/// Fractions, and symbols that stand for fractions.
class NumberDomain {
 public:
  using Value = Amount;

  explicit NumberDomain(const NumberSymbols& symbols) : m_symbols(symbols) {}

  [[nodiscard]] bool failed() const { return m_failed; }
  [[nodiscard]] bool hasUnknownName() const { return m_hasUnknownName; }

  static Amount constant(const Rational& value, const Rational& slack) { return {value, slack}; }

  Amount add(Amount sum, const Amount& part, bool isNegative) {
    isNegative ? sum.value -= part.value : sum.value += part.value;
    sum.slack += part.slack;
    return bounded(std::move(sum));
  }
  Amount multiply(const Amount& a, const Amount& b) {
    Rational slack = 0;
    if (!a.slack.isZero() || !b.slack.isZero())
      slack = a.value.abs() * b.slack + b.value.abs() * a.slack + a.slack * b.slack;
    return bounded({a.value * b.value, slack});
  }
  Amount inverse(Amount amount) {
    if (amount.value.isZero()) {
      m_failed = true;
      return amount;
    }
    amount.slack /= amount.value * amount.value;
    amount.value = amount.value.inverse();
    return amount;
  }
  Amount named(const WrittenName& name) {
    const std::string primes(static_cast<std::size_t>(name.primes), '\'');
    std::string links = name.subscript;
    auto found = m_symbols.find(name.base + links + primes);
    if (found == m_symbols.end()) {
      std::erase(links, '_');
      found = m_symbols.find(name.base + links + primes);
    }
    const bool isOneDigitEach = links.size() == name.subscript.size() || name.subscript.size() == 3;
    if (found != m_symbols.end() && isOneDigitEach) return {*Rational::fromText(found->second), 0};
    m_failed = m_hasUnknownName = true;
    return {};
  }

 private:
  Amount bounded(Amount amount) {
    if (amount.value.toString().size() > kMaxDigits) m_failed = true;
    return amount;
  }

  const NumberSymbols& m_symbols;
  bool m_failed = false;
  bool m_hasUnknownName = false;
};

/// A way to write a unit, in plain notation, and how many of the unit of its dimension it is; 0: not
/// converted.
struct UnitSpelling {
  std::string_view text;
  std::string_view unit;
  std::string_view factor;
};

constexpr std::array kUnits = {
    UnitSpelling{"rad/s", "rad/s", "1"},    UnitSpelling{"rad s^-1", "rad/s", "1"},
    UnitSpelling{"rad*s^-1", "rad/s", "1"}, UnitSpelling{"rad s^{-1}", "rad/s", "1"},
    UnitSpelling{"s^{-1}", "rad/s", "1"},   UnitSpelling{"s^-1", "rad/s", "1"},
    UnitSpelling{" 1/s", "rad/s", "1"},     UnitSpelling{"/s", "rad/s", "1"},
    UnitSpelling{"deg/s", "rad/s", "0"},    UnitSpelling{"°/s", "rad/s", "0"},
    UnitSpelling{"rpm", "rad/s", "0"},      UnitSpelling{" 1/min", "rad/s", "0"},
    UnitSpelling{"U/min", "rad/s", "0"},    UnitSpelling{"r/min", "rad/s", "0"},
    UnitSpelling{"/min", "rad/s", "0"},     UnitSpelling{"N m", "N m", "1"},
    UnitSpelling{"Nm", "N m", "1"},         UnitSpelling{"N*m", "N m", "1"},
    UnitSpelling{"kN m", "N m", "1000"},    UnitSpelling{"kNm", "N m", "1000"},
    UnitSpelling{"kN*m", "N m", "1000"},    UnitSpelling{"N cm", "N m", "1/100"},
    UnitSpelling{"Ncm", "N m", "1/100"},    UnitSpelling{"N*cm", "N m", "1/100"},
    UnitSpelling{"N mm", "N m", "1/1000"},  UnitSpelling{"Nmm", "N m", "1/1000"},
    UnitSpelling{"N*mm", "N m", "1/1000"},  UnitSpelling{"mN m", "N m", "1/1000"},
    UnitSpelling{"mNm", "N m", "1/1000"},   UnitSpelling{"mN*m", "N m", "1/1000"},
    UnitSpelling{"ft", "N m", "0"},         UnitSpelling{"W", "W", "1"},
    UnitSpelling{"kW", "W", "1000"},        UnitSpelling{"rad", "rad", "1"},
    UnitSpelling{"deg", "rad", "0"},        UnitSpelling{"mm", "mm", "1"},
    UnitSpelling{"°", "rad", "0"},
};

/// The longest unit at the end of the text, after a number and not after a letter.
const UnitSpelling* unitOf(std::string_view text) {
  const auto isLetter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  const UnitSpelling* found = nullptr;
  for (const UnitSpelling& unit : kUnits) {
    if (!text.ends_with(unit.text) || text.size() == unit.text.size()) continue;
    const char before = text[text.size() - unit.text.size() - 1];
    const bool isJoined = isLetter(before) || before == '_' || before == '^';
    if (!isJoined && (found == nullptr || unit.text.size() > found->text.size())) found = &unit;
  }
  return found;
}

NumberFault faultOf(const ExpressionStop& stop, const NumberDomain& domain) {
  if (stop.fault == ExpressionFault::none) return NumberFault::none;
  if (stop.fault == ExpressionFault::ambiguous) return NumberFault::ambiguous;
  if (stop.fault == ExpressionFault::meaning && domain.hasUnknownName()) return NumberFault::unknownName;
  return NumberFault::notANumber;
}

}  // namespace

CommaUse commaUse() {
  return decimalSign() == ',' ? CommaUse::decimal : CommaUse::ambiguous;
}

WrittenNumber readNumber(std::string_view text, const NumberNotation& notation) {
  if (text.size() > kMaxLength || text.find('\0') != std::string_view::npos)
    return {NumberFault::notANumber, {}, {}, {}};
  std::string plain = plainNotation(text);
  while (plain.ends_with(' ')) plain.pop_back();
  Rational factor = 1;
  if (const UnitSpelling* const unit = unitOf(plain)) {
    factor = *Rational::fromText(unit->factor);
    if (unit->unit != notation.unit || factor.isZero())
      return {
          NumberFault::otherUnit, {}, {}, std::string(unit->text.substr(unit->text.find_first_not_of(' ')))};
    plain.resize(plain.size() - unit->text.size());
  }
  NumberDomain domain(notation.symbols);
  ExpressionReader<NumberDomain> reader(domain, std::move(plain), notation.comma);
  const Amount amount = reader.read();
  if (const NumberFault fault = faultOf(reader.stop(), domain); fault != NumberFault::none)
    return {fault, {}, {}, reader.stop().text};
  return {NumberFault::none, amount.value * factor, amount.slack * factor, {}};
}

}  // namespace geargraph
