#include <algorithm>
#include <cctype>
#include <vector>

#include "core/exact/rational_function.h"

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

std::string power(const std::string& name, ulong exponent, const Style& style) {
  const std::string base = style.latex ? latexName(name) : name;
  if (exponent == 1) return base;
  const std::string digits = std::to_string(exponent);
  return style.latex ? base + "^{" + digits + "}" : base + "^" + digits;
}

/// One polynomial, printed term by term.
class Printer {
 public:
  Printer(const fmpz_mpoly_struct* polynomial, const RatioRing& ring, const Style& style)
      : m_polynomial(polynomial), m_ring(ring), m_style(style) {}

  [[nodiscard]] slong terms() const { return fmpz_mpoly_length(m_polynomial, m_ring.context()); }

  /// May it stand behind "/" without parentheses? "i17", "3", "i17^2" may, "2*i17" may not.
  [[nodiscard]] bool isOneFactor() const {
    return terms() == 1 && text().find(m_style.times) == std::string::npos;
  }

  [[nodiscard]] std::string text() const {
    std::string sum;
    for (slong term = 0; term < terms(); ++term) {
      const Rational coefficient = coefficientOf(term);
      const bool negative = coefficient.sign() < 0;
      if (term == 0) {
        if (negative) sum += "-";
      } else {
        sum += negative ? " - " : " + ";
      }
      sum += product(coefficient.abs(), term);
    }
    return sum;
  }

 private:
  [[nodiscard]] Rational coefficientOf(slong term) const {
    Rational coefficient;
    fmpz_mpoly_get_term_coeff_fmpz(fmpq_numref(coefficient.flint()), m_polynomial, term, m_ring.context());
    return coefficient;
  }

  /// A term without its sign: the coefficient where it is not 1, then the ratios, highest label first.
  [[nodiscard]] std::string product(const Rational& coefficient, slong term) const {
    std::vector<ulong> exponents(static_cast<std::size_t>(m_ring.variables()));
    fmpz_mpoly_get_term_exp_ui(exponents.data(), m_polynomial, term, m_ring.context());
    std::string factors;
    if (coefficient != Rational(1)) factors = coefficient.toString();
    for (std::size_t i = exponents.size(); i-- > 0;) {
      if (exponents[i] == 0) continue;
      if (!factors.empty()) factors += m_style.times;
      factors += power(m_ring.name(static_cast<int>(i)), exponents[i], m_style);
    }
    return factors.empty() ? "1" : factors;
  }

  const fmpz_mpoly_struct* m_polynomial;
  const RatioRing& m_ring;
  Style m_style;
};

std::string inParentheses(const std::string& text) {
  return "(" + text + ")";
}

}  // namespace

std::string RationalFunction::toText() const {
  if (isZero()) return "0";
  const Printer above(m_numerator, *m_ring, kText);
  if (fmpz_mpoly_is_one(m_denominator, m_ring->context()) != 0) return above.text();
  const Printer below(m_denominator, *m_ring, kText);
  return (above.terms() > 1 ? inParentheses(above.text()) : above.text()) + "/" +
         (below.isOneFactor() ? below.text() : inParentheses(below.text()));
}

std::string RationalFunction::toLatex() const {
  if (isZero()) return "0";
  std::string above = Printer(m_numerator, *m_ring, kLatex).text();
  if (fmpz_mpoly_is_one(m_denominator, m_ring->context()) != 0) return above;
  const bool negative = above[0] == '-' && fmpz_mpoly_length(m_numerator, m_ring->context()) == 1;
  if (negative) above.erase(0, 1);
  const std::string below = Printer(m_denominator, *m_ring, kLatex).text();
  return std::string(negative ? "-" : "") + "\\frac{" + above + "}{" + below + "}";
}

}  // namespace geargraph
