#include "core/teaching/work_check/equation_check.h"

#include <algorithm>
#include <set>

#include "core/foundations/base/translation.h"

namespace geargraph {
namespace {

/// What an equation is short of: right side minus left side, over each input. Numbers agree up to their
/// slack.
struct Residual {
  std::vector<RationalFunction> functions;  ///< by input
  std::vector<Rational> values;
  std::vector<Rational> slacks;
};

std::string differenceInWords(const Rational& value) {
  const std::string text = value.toString();
  return value.sign() < 0 ? "\u2212" + text.substr(1) : text;
}

class EquationCheck {
 public:
  EquationCheck(const Vocabulary& vocabulary, const std::stop_token& stop)
      : m_vocabulary(vocabulary), m_source(vocabulary.source()), m_stop(stop) {
    const auto solved = solvedKinematics(m_source.mechanism(), *m_source.snapshot()->kinematics, {}, stop);
    if (solved && solved->symbolic) takeSymbols(*solved->symbolic);
  }

  Expected<EquationVerdict> check(const WrittenEquation& equation) const {
    EquationVerdict verdict;
    verdict.line = equation.sides.front().line;
    std::vector<WrittenFormula> sides;
    for (const WrittenCell& side : equation.sides) {
      auto formula = readFormula(m_vocabulary, side);
      if (!formula) return formula.error();
      sides.push_back(std::move(formula).value());
      verdict.text += (verdict.text.empty() ? "" : " = ") + side.text;
    }
    verdict.isRight = true;
    for (std::size_t i = 0; i + 1 < sides.size() && verdict.isRight; ++i) {
      WrittenFormula difference = sides[i];
      if (auto fault = constantFault(sides, equation.sides[i])) return *fault;
      for (WrittenFormula::Term term : sides[i + 1].terms) {
        term.coefficient.value = -term.coefficient.value;
        difference.terms.push_back(std::move(term));
      }
      verdict.isRight = holds(difference.terms);
      if (!verdict.isRight) verdict.difference = explained(difference.terms);
    }
    std::set<ElementId> elements;
    for (const WrittenFormula& side : sides) addElements(side.terms, elements);
    verdict.elements.assign(elements.begin(), elements.end());
    return verdict;
  }

 private:
  using Terms = std::vector<WrittenFormula::Term>;

  void takeSymbols(const SymbolicSolution& symbolic) {
    const std::size_t width = symbolic.inputs.size();
    m_functions.assign(static_cast<std::size_t>(m_source.graph().t()),
                       std::vector<RationalFunction>(width, m_vocabulary.constant(0)));
    for (std::size_t i = 0; i < width; ++i)
      m_functions[static_cast<std::size_t>(symbolic.inputs[i])][i] = m_vocabulary.constant(1);
    for (std::size_t row = 0; row < symbolic.outputs.size(); ++row) {
      for (std::size_t i = 0; i < width; ++i) {
        const auto& entry = symbolic.matrix[row * width + i];
        if (!entry) {
          m_functions.clear();
          return;
        }
        m_functions[static_cast<std::size_t>(symbolic.outputs[row])][i] = *entry;
      }
    }
  }

  /// Equations of velocities have no term without one.
  static std::optional<Diagnostic> constantFault(const std::vector<WrittenFormula>& sides,
                                                 const WrittenCell& place) {
    bool hasVelocity = false;
    bool hasConstant = false;
    for (const WrittenFormula& side : sides) {
      hasVelocity = hasVelocity || !side.terms.empty();
      hasConstant = hasConstant || !side.amount.value.isZero();
    }
    if (hasVelocity && !hasConstant) return std::nullopt;
    Diagnostic fault{
        Code::syntax,
        hasVelocity
            ? translated(
                  "An equation between velocities has no number without one: write the input's velocity.")
            : translated("This equation has no velocity: write θ or ω with a label."),
        {},
        {}};
    fault.line = place.line;
    fault.column = place.column;
    return fault;
  }

  void addElements(const Terms& terms, std::set<ElementId>& elements) const {
    for (const WrittenFormula::Term& term : terms) {
      for (const auto& [joint, factor] : term.rates) elements.insert(m_source.edgeId(joint));
    }
  }

  [[nodiscard]] Rational rate(JointOrdinal joint, std::size_t input) const {
    return m_source.rates()[static_cast<std::size_t>(joint)][input];
  }
  /// What a velocity is over an input, as a number.
  [[nodiscard]] Rational speed(const RateSum& rates, std::size_t input) const {
    Rational sum = 0;
    for (const auto& [joint, factor] : rates) sum += Rational(factor) * rate(joint, input);
    return sum;
  }

  /// Is the sum of the terms 0 in every motion? Symbols must vanish for all ratios, if there are no numbers
  /// among them.
  [[nodiscard]] bool holds(const Terms& terms) const {
    if (!holdsInNumbers(terms)) return false;
    return !isSymbolic(terms) || m_functions.empty() || !m_vocabulary.ratiosAreFree() ||
           holdsInSymbols(terms);
  }
  static bool isSymbolic(const Terms& terms) {
    return std::any_of(terms.begin(), terms.end(),
                       [](const auto& term) { return term.coefficient.hasRatios; }) &&
           std::none_of(terms.begin(), terms.end(),
                        [](const auto& term) { return term.coefficient.hasNumbers; });
  }
  [[nodiscard]] bool holdsInNumbers(const Terms& terms) const {
    std::vector<Rational> coefficients;
    for (const auto& term : terms) coefficients.push_back(m_vocabulary.atTeeth(term.coefficient.value));
    return vanishes(terms, coefficients);
  }
  [[nodiscard]] bool vanishes(const Terms& terms, const std::vector<Rational>& coefficients) const {
    for (std::size_t input = 0; input < m_source.inputs().size(); ++input) {
      Rational sum = 0;
      Rational slack = 0;
      for (std::size_t i = 0; i < terms.size(); ++i) {
        const Rational own = speed(terms[i].rates, input);
        sum += coefficients[i] * own;
        slack += terms[i].coefficient.slack * own.abs();
      }
      if (!sum.isZero() && !(sum.abs() < slack)) return false;
    }
    return true;
  }
  [[nodiscard]] bool holdsInSymbols(const Terms& terms) const {
    for (std::size_t input = 0; input < m_source.inputs().size(); ++input) {
      RationalFunction sum = m_vocabulary.constant(0);
      for (const auto& term : terms) {
        for (const auto& [joint, factor] : term.rates)
          sum += term.coefficient.value * m_functions[static_cast<std::size_t>(joint)][input] *
                 m_vocabulary.constant(factor);
      }
      if (!sum.isZero()) return false;
    }
    return true;
  }

  /// The mistake that, undone, makes the equation true.
  [[nodiscard]] WorkDifference explained(const Terms& terms) const {
    std::vector<Rational> coefficients;
    for (const auto& term : terms) coefficients.push_back(m_vocabulary.atTeeth(term.coefficient.value));
    if (vanishes(terms, coefficients)) {
      return {
          "another-ratio-symbol",
          {},
          elementsOf(terms),
          translated("The equation is true for these teeth and not for all: it holds another mesh's ratio.")};
    }
    if (auto found = signMistake(terms, coefficients)) return *found;
    if (auto found = ratioMistake(terms, coefficients)) return *found;
    if (auto found = missingVelocity(terms, coefficients)) return *found;
    if (auto found = otherVelocity(terms, coefficients)) return *found;
    return {"equation-does-not-hold", {}, elementsOf(terms), residualText(terms, coefficients)};
  }

  [[nodiscard]] std::vector<ElementId> elementsOf(const Terms& terms) const {
    std::set<ElementId> elements;
    addElements(terms, elements);
    return {elements.begin(), elements.end()};
  }
  [[nodiscard]] std::vector<ElementId> elementsOf(const RateSum& rates) const {
    std::vector<ElementId> elements;
    for (const auto& [joint, factor] : rates) elements.push_back(m_source.edgeId(joint));
    return elements;
  }
  static std::string shown(const WrittenName& name) {
    return (name.base == "theta" ? "\u03b8" : "\u03c9") + name.subscript +
           std::string(static_cast<std::size_t>(name.primes), '\'');
  }

  [[nodiscard]] std::optional<WorkDifference> signMistake(const Terms& terms,
                                                          std::vector<Rational> coefficients) const {
    // The last term first: what is computed is on the left.
    for (std::size_t i = terms.size(); i-- > 0;) {
      coefficients[i] = -coefficients[i];
      const bool isTrue = vanishes(terms, coefficients);
      coefficients[i] = -coefficients[i];
      if (!isTrue) continue;
      const bool isCircuit = std::all_of(coefficients.begin(), coefficients.end(),
                                         [](const Rational& c) { return c.abs() == Rational(1); });
      return WorkDifference{
          isCircuit && terms.size() > 2 ? "walked-against-arrow" : "mesh-sign",
          {},
          elementsOf(terms[i].rates),
          translated("The sign of the term with %1 is wrong: with the other one the equation holds.",
                     {shown(terms[i].name)})};
    }
    return std::nullopt;
  }

  [[nodiscard]] std::optional<WorkDifference> ratioMistake(const Terms& terms,
                                                           const std::vector<Rational>& coefficients) const {
    const auto values = m_vocabulary.ring()->values();
    for (MeshOrdinal mesh = 0; mesh < m_vocabulary.ring()->variables(); ++mesh) {
      std::vector<Rational> turned(values.begin(), values.end());
      turned[static_cast<std::size_t>(mesh)] = turned[static_cast<std::size_t>(mesh)].inverse();
      std::vector<Rational> changed;
      for (const auto& term : terms)
        changed.push_back(term.coefficient.value.valueAt(turned).value_or(Rational(0)));
      if (changed == coefficients) continue;
      const std::string name = m_vocabulary.ring()->name(mesh);
      if (vanishes(terms, changed))
        return WorkDifference{
            "ratio-upside-down",
            {},
            {m_source.meshId(mesh)},
            translated("The ratio %1 is upside down: it is N of the tail over N of the head.", {name})};
      for (std::size_t i = 0; i < changed.size(); ++i) {
        changed[i] = -changed[i];
        if (vanishes(terms, changed))
          return WorkDifference{
              "sign-and-ratio",
              {},
              {m_source.meshId(mesh)},
              translated("The ratio %1 is upside down, and a sign is wrong besides.", {name})};
        changed[i] = -changed[i];
      }
    }
    std::vector<Rational> changed = coefficients;
    for (std::size_t i = 0; i < changed.size(); ++i) {
      if (changed[i].isZero() || changed[i].abs() == Rational(1)) continue;
      changed[i] = coefficients[i].inverse();
      if (vanishes(terms, changed))
        return WorkDifference{"ratio-upside-down",
                              {},
                              elementsOf(terms[i].rates),
                              translated("The number before %1 is upside down.", {shown(terms[i].name)})};
      changed[i] = coefficients[i];
    }
    return std::nullopt;
  }

  [[nodiscard]] std::optional<WorkDifference> missingVelocity(
      const Terms& terms, const std::vector<Rational>& coefficients) const {
    Terms longer = terms;
    longer.push_back({{}, {}, {m_vocabulary.constant(1), false, false, 0}});
    std::vector<Rational> changed = coefficients;
    changed.emplace_back(0);
    for (JointOrdinal joint = 0; joint < m_source.graph().t(); ++joint) {
      longer.back().rates = {{joint, 1}};
      for (const Rational& coefficient : coefficients) {
        for (const bool isNegative : {false, true}) {
          changed.back() = isNegative ? -coefficient : coefficient;
          if (vanishes(longer, changed))
            return WorkDifference{"term-left-out",
                                  {},
                                  {m_source.edgeId(joint)},
                                  translated("A term with θ%1 is left out.", {m_source.edgeLabel(joint)})};
        }
      }
    }
    return std::nullopt;
  }

  [[nodiscard]] std::optional<WorkDifference> otherVelocity(Terms terms,
                                                            const std::vector<Rational>& coefficients) const {
    for (auto& term : terms) {
      const RateSum own = term.rates;
      for (JointOrdinal joint = 0; joint < m_source.graph().t(); ++joint) {
        term.rates = {{joint, 1}};
        if (term.rates == own || !vanishes(terms, coefficients)) continue;
        return WorkDifference{
            "another-velocity",
            {},
            elementsOf(own),
            translated("In place of %1 there should be θ%2.", {shown(term.name), m_source.edgeLabel(joint)})};
      }
      term.rates = own;
    }
    return std::nullopt;
  }

  [[nodiscard]] std::string residualText(const Terms& terms,
                                         const std::vector<Rational>& coefficients) const {
    for (std::size_t input = 0; input < m_source.inputs().size(); ++input) {
      Rational sum = 0;
      for (std::size_t i = 0; i < terms.size(); ++i) sum += coefficients[i] * speed(terms[i].rates, input);
      if (sum.isZero()) continue;
      return translated(
          "With θ%1 = 1 and the other inputs at rest the left side is greater than the right one by "
          "%2.",
          {m_source.edgeLabel(m_source.inputs()[input]), differenceInWords(sum)});
    }
    return translated("The equation is true for these teeth only.");
  }

  const Vocabulary& m_vocabulary;
  const ExerciseSource& m_source;
  std::stop_token m_stop;
  std::vector<std::vector<RationalFunction>> m_functions;  ///< by joint and input; empty: numbers only
};

}  // namespace

Expected<std::vector<EquationVerdict>> checkEquations(const Vocabulary& vocabulary,
                                                      const std::vector<WrittenEquation>& equations,
                                                      const std::stop_token& stop) {
  const ExerciseSource& source = vocabulary.source();
  if (source.matroid() == nullptr) {
    if (hasErrors(source.snapshot()->diagnostics)) return source.snapshot()->diagnostics;
    Diagnostic fault{
        Code::noMeshes, translated("This mechanism has no motion to check an equation against."), {}, {}};
    return Expected<std::vector<EquationVerdict>>(fault);
  }
  const EquationCheck check(vocabulary, stop);
  std::vector<EquationVerdict> verdicts;
  for (const WrittenEquation& equation : equations) {
    if (stop.stop_requested()) break;
    auto verdict = check.check(equation);
    if (!verdict) return verdict.error();
    verdicts.push_back(std::move(verdict).value());
  }
  return verdicts;
}

}  // namespace geargraph
