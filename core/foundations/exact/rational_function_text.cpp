#include <algorithm>
#include <cctype>
#include <vector>

#include "core/foundations/exact/rational_function.h"

namespace geargraph {
namespace {

/// How the parts of a formula are written.
struct Style {
  const char* times;
  bool latex;
};
constexpr Style kText{"*", false};
constexpr Style kLatex{" ", true};

/// "i15" as "i_{15}", "n12_3" as "n_{12,3}".
std::string latexName(const std::string& name) {
  std::size_t at = 0;
  while (at < name.size() && std::isdigit(static_cast<unsigned char>(name[at])) == 0) ++at;
  if (at == 0 || at == name.size()) return name;
  std::string label = name.substr(at);
  std::replace(label.begin(), label.end(), '_', ',');
  return name.substr(0, at) + "_{" + label + "}";
}

std::string powerText(const std::string& name, ulong exponent, const Style& style) {
  const std::string base = style.latex ? latexName(name) : name;
  if (exponent == 1) return base;
  const std::string digits = std::to_string(exponent);
  return style.latex ? base + "^{" + digits + "}" : base + "^" + digits;
}

std::string inParentheses(const std::string& text) {
  return "(" + text + ")";
}

}  // namespace

/// Numerator or denominator, printed term by term.
class RationalFunction::Printer {
 public:
  Printer(const Terms& terms, const RatioRing& ring, const Style& style)
      : m_terms(terms), m_ring(ring), m_style(style) {}

  [[nodiscard]] std::size_t terms() const { return m_terms.size(); }
  [[nodiscard]] bool isOne() const {
    return terms() == 1 && m_terms.front().powers.empty() && m_terms.front().coefficient == Rational(1);
  }

  /// May it stand behind "/" without parentheses? "i17", "3", "i17^2" may, "2*i17" may not.
  [[nodiscard]] bool isOneFactor() const {
    return terms() == 1 && text().find(m_style.times) == std::string::npos;
  }

  [[nodiscard]] std::string text() const {
    std::string sum;
    for (const auto& term : m_terms) {
      const bool negative = term.coefficient.sign() < 0;
      if (sum.empty()) {
        if (negative) sum += "-";
      } else {
        sum += negative ? " - " : " + ";
      }
      sum += product(term.coefficient.abs(), term.powers);
    }
    return sum;
  }

 private:
  /// A term without its sign: the coefficient where it is not 1, then the ratios, highest label first.
  template <class Powers>
  [[nodiscard]] std::string product(const Rational& coefficient, const Powers& powers) const {
    std::string factors;
    if (coefficient != Rational(1)) factors = coefficient.toString();
    for (auto factor = powers.rbegin(); factor != powers.rend(); ++factor) {
      if (!factors.empty()) factors += m_style.times;
      factors += powerText(m_ring.name(factor->first), factor->second, m_style);
    }
    return factors.empty() ? "1" : factors;
  }

  const Terms& m_terms;
  const RatioRing& m_ring;
  Style m_style;
};

std::string RationalFunction::toText() const {
  if (isZero()) return "0";
  const Quotient terms = quotient();
  const Printer above(terms.above, *m_ring, kText);
  const Printer below(terms.below, *m_ring, kText);
  if (below.isOne()) return above.text();
  return (above.terms() > 1 ? inParentheses(above.text()) : above.text()) + "/" +
         (below.isOneFactor() ? below.text() : inParentheses(below.text()));
}

std::string RationalFunction::toLatex() const {
  if (isZero()) return "0";
  const Quotient terms = quotient();
  const Printer below(terms.below, *m_ring, kLatex);
  std::string above = Printer(terms.above, *m_ring, kLatex).text();
  if (below.isOne()) return above;
  const bool negative = above[0] == '-' && terms.above.size() == 1;
  if (negative) above.erase(0, 1);
  return std::string(negative ? "-" : "") + "\\frac{" + above + "}{" + below.text() + "}";
}

}  // namespace geargraph
