#include "core/teaching/work_check/written_formula.h"

#include <algorithm>
#include <utility>

#include "core/foundations/base/translation.h"
#include "core/teaching/grading/number_text.h"

namespace geargraph {
namespace {

constexpr std::size_t kMaxLength = 2'000;
constexpr std::size_t kMaxTerms = 500;
constexpr std::int64_t kLargestFunction = 20'000;

/// What the numbers and symbols of a cell are: functions of the ratios, and velocities with such
/// coefficients.
class FormulaDomain {
 public:
  using Value = WrittenFormula;

  explicit FormulaDomain(const Vocabulary& vocabulary) : m_vocabulary(vocabulary) {}

  [[nodiscard]] bool failed() const { return !m_fault.empty(); }
  [[nodiscard]] const std::string& fault() const { return m_fault; }

  [[nodiscard]] WrittenFormula constant(const Rational& value, const Rational& slack) const {
    WrittenFormula formula;
    const bool isMeasured = !value.isZero() && value.abs() != Rational(1);
    formula.amount = {m_vocabulary.constant(value), false, isMeasured, slack};
    return formula;
  }

  WrittenFormula add(WrittenFormula whole, const WrittenFormula& part, bool isNegative) {
    WrittenAmount& to = whole.amount;
    isNegative ? to.value -= part.amount.value : to.value += part.amount.value;
    to.hasRatios = to.hasRatios || part.amount.hasRatios;
    to.hasNumbers = to.hasNumbers || part.amount.hasNumbers;
    to.slack += part.amount.slack;
    if (whole.terms.size() + part.terms.size() > kMaxTerms || isTooLarge(to)) return tooLong(whole);
    for (const WrittenFormula::Term& term : part.terms) {
      whole.terms.push_back(term);
      if (isNegative) whole.terms.back().coefficient.value = -term.coefficient.value;
    }
    return whole;
  }

  WrittenFormula multiply(WrittenFormula a, const WrittenFormula& b) {
    if (!b.terms.empty()) {
      if (a.terms.empty()) return multiply(b, a);
      fail(translated("A velocity is multiplied by a velocity here."));
      return a;
    }
    for (WrittenFormula::Term& term : a.terms) term.coefficient = times(term.coefficient, b.amount);
    a.amount = times(a.amount, b.amount);
    return isTooLarge(a.amount) ? tooLong(a) : a;
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

  WrittenFormula named(const WrittenName& name) {
    std::string why;
    WrittenFormula formula;
    formula.amount.value = m_vocabulary.constant(0);
    if (Vocabulary::isRate(name)) {
      const auto rates = m_vocabulary.rate(name, why);
      if (!rates) fail(why);
      if (rates) formula.terms.push_back({name, *rates, {m_vocabulary.constant(1), false, false, 0}});
      return formula;
    }
    const auto value = m_vocabulary.value(name, why);
    if (!value) {
      fail(why);
      return formula;
    }
    formula.amount = {value->value, value->isRatio, !value->isRatio, 0};
    return formula;
  }

 private:
  void fail(std::string message) {
    if (m_fault.empty()) m_fault = std::move(message);
  }
  static bool isTooLarge(const WrittenAmount& amount) { return amount.value.size() > kLargestFunction; }
  WrittenFormula tooLong(WrittenFormula formula) {
    fail(translated("This formula is too long."));
    return formula;
  }

  [[nodiscard]] WrittenAmount times(const WrittenAmount& a, const WrittenAmount& b) const {
    Rational slack = 0;
    if (!a.slack.isZero() || !b.slack.isZero()) {
      slack = m_vocabulary.atTeeth(a.value).abs() * b.slack + m_vocabulary.atTeeth(b.value).abs() * a.slack +
              a.slack * b.slack;
    }
    return {a.value * b.value, a.hasRatios || b.hasRatios, a.hasNumbers || b.hasNumbers, slack};
  }

  const Vocabulary& m_vocabulary;
  std::string m_fault;
};

std::string messageOf(const ExpressionStop& stop, const FormulaDomain& domain, const WrittenCell& cell) {
  switch (stop.fault) {
    case ExpressionFault::missing:
      return translated("An entry is missing here.");
    case ExpressionFault::ambiguous:
      return translated("“%1” can be read as a thousand or as a decimal: write it without the comma.",
                        {stop.text});
    case ExpressionFault::notANumber:
      return translated("“%1” is not a number.", {stop.text});
    case ExpressionFault::tooDeep:
      return translated("This formula has too many parentheses inside each other.");
    case ExpressionFault::power: {
      constexpr int kHighest = ExpressionReader<FormulaDomain>::kHighestPower;
      return translated("A power needs a whole number of at most %1.", {std::to_string(kHighest)});
    }
    case ExpressionFault::meaning:
      return domain.fault();
    case ExpressionFault::none:
    case ExpressionFault::unexpected:
      break;
  }
  return translated(
      "“%1” cannot be read: write a number, a fraction or names such as i15, n41, N4, θ8 or "
      "ω51.",
      {cell.text});
}

Diagnostic formulaFault(const WrittenCell& cell, std::string message) {
  Diagnostic fault{Code::syntax, std::move(message), {}, {}};
  fault.line = cell.line;
  fault.column = cell.column;
  return fault;
}

}  // namespace

std::optional<WrittenName> readName(const std::string& text) {
  const std::string plain = plainNotation(text);
  std::size_t at = std::min(plain.find_first_not_of(' '), plain.size());
  auto name = nameAt(plain, at);
  if (!name || plain.find_first_not_of(' ', at) != std::string::npos) return std::nullopt;
  return name;
}

Expected<WrittenFormula> readFormula(const Vocabulary& vocabulary, const WrittenCell& cell) {
  std::string plain = plainNotation(cell.text);
  if (plain.size() > kMaxLength) return formulaFault(cell, translated("This formula is too long."));
  FormulaDomain domain(vocabulary);
  ExpressionReader<FormulaDomain> reader(domain, std::move(plain), commaUse());
  WrittenFormula whole = reader.read();
  if (reader.stop().fault == ExpressionFault::none) return whole;
  return formulaFault(cell, messageOf(reader.stop(), domain, cell));
}

Expected<WrittenAmount> readAmount(const Vocabulary& vocabulary, const WrittenCell& cell) {
  auto formula = readFormula(vocabulary, cell);
  if (!formula) return formula.error();
  if (!formula->terms.empty()) {
    return formulaFault(
        cell, translated("“%1” holds a velocity, and an entry of a matrix is a number.", {cell.text}));
  }
  return formula->amount;
}

}  // namespace geargraph
