#include "core/teaching/work_check/table_check.h"

#include <algorithm>

#include "core/foundations/base/locale.h"
#include "core/foundations/base/text_lists.h"
#include "core/foundations/base/translation.h"
#include "core/teaching/work_check/table_trial.h"

namespace geargraph {
namespace {

constexpr std::size_t kMaxNamed = 12;

Diagnostic faultAt(const WrittenCell& cell, std::string message) {
  Diagnostic fault{Code::syntax, std::move(message), {}, {}};
  fault.line = cell.line;
  fault.column = cell.column;
  return fault;
}

std::string sizeText(int rows, int columns) {
  return std::to_string(rows) + " \u00d7 " + std::to_string(columns);
}

std::string quoted(const std::string& text) {
  return "\u201c" + text + "\u201d";
}

/// Which matrix the name in front of it says: "C = [...]".
std::optional<PaperMatrix> kindOfName(const std::string& name) {
  const std::string plain = plainNotation(name);
  const auto is = [&](std::string_view a, std::string_view b) { return plain == a || plain == b; };
  if (is("Gamma0", "\\Gamma^0") || plain == "\u0393\u2070" || plain == "\\Gamma^{0}")
    return PaperMatrix::incidence;
  if (is("Gamma", "\\Gamma") || plain == "\u0393") return PaperMatrix::reducedIncidence;
  constexpr std::string_view kLetters = "ZTCQPS";
  if (plain.size() != 1 || kLetters.find(plain) == std::string_view::npos) return std::nullopt;
  return static_cast<PaperMatrix>(static_cast<std::size_t>(PaperMatrix::path) + kLetters.find(plain));
}

class TableCheck {
 public:
  TableCheck(const Vocabulary& vocabulary, const WrittenTable& table, const std::stop_token& stop)
      : m_vocabulary(vocabulary), m_table(table), m_stop(stop) {}

  Expected<MatrixVerdict> run(std::optional<PaperMatrix> kind) {
    for (const auto& row : m_table.cells) {
      auto& amounts = m_amounts.emplace_back();
      for (const WrittenCell& cell : row) {
        auto amount = readAmount(m_vocabulary, cell);
        if (!amount) return amount.error();
        amounts.push_back(std::move(amount).value());
      }
    }
    if (kind) return asked(*kind);
    return recognised();
  }

 private:
  [[nodiscard]] TableTrial trial(PaperMatrix kind) const {
    return {m_vocabulary, m_table, m_amounts, kind, m_stop};
  }

  Expected<MatrixVerdict> asked(PaperMatrix kind) const {
    TableTrial own = trial(kind);
    if (!own.isDefined()) return undefined(kind);
    if (own.isRight()) return own.verdict();
    own.explain();
    if (own.cost() <= 1) return own.verdict();
    if (const WrittenCell* label = own.unknownLabel(); label != nullptr)
      return unknownLabel(*label, kind, own.right());
    if (const auto other = rightAsAnother(kind)) {
      MatrixVerdict verdict = std::move(own.verdict());
      verdict.differences = {{"another-matrix",
                              {},
                              {},
                              translated("This is %1, not %2.", {described(*other), described(kind)})}};
      return verdict;
    }
    if (own.cost() == TableTrial::kNotComparable) {
      own.verdict().differences = {
          {"another-size",
           {},
           {},
           translated("%1 has the size %2 for this mechanism, and yours is %3.",
                      {described(kind), sizeText(own.right().height(), own.right().width()),
                       sizeText(m_table.rows(), m_table.columns())})}};
    }
    return own.verdict();
  }

  [[nodiscard]] std::optional<PaperMatrix> rightAsAnother(PaperMatrix kind) const {
    for (const PaperMatrix other : allPaperMatrices()) {
      if (other == kind) continue;
      TableTrial tried = trial(other);
      if (tried.isDefined() && tried.isRight() && tried.verdict().outcome == WorkOutcome::right) return other;
    }
    return std::nullopt;
  }

  /// The first that it is right as; else the one of which the fewest entries differ.
  Expected<MatrixVerdict> recognised() const {
    std::vector<PaperMatrix> kinds = allPaperMatrices();
    const auto named = kindOfName(m_table.name);
    if (named) kinds = {*named};
    std::optional<MatrixVerdict> best;
    std::size_t least = TableTrial::kNotComparable;
    std::vector<TableTrial> trials;
    std::optional<MatrixVerdict> ambiguous;
    for (const PaperMatrix kind : kinds) {
      TableTrial& tried = trials.emplace_back(trial(kind));
      if (!tried.isDefined() || !tried.isRight()) continue;
      tried.verdict().isRecognised = true;
      if (tried.verdict().outcome == WorkOutcome::right) return tried.verdict();
      if (!ambiguous) ambiguous = tried.verdict();
    }
    if (ambiguous) return *ambiguous;
    const WrittenCell* label = nullptr;
    PaperMatrix kindOfLabel = PaperMatrix::incidence;
    for (TableTrial& tried : trials) {
      if (!tried.isDefined()) continue;
      tried.explain();
      if (const WrittenCell* own = tried.unknownLabel(); own != nullptr) {
        label = own;
        kindOfLabel = tried.verdict().kind;
      }
      if (tried.cost() >= least) continue;
      least = tried.cost();
      best = tried.verdict();
    }
    if (best) {
      best->isRecognised = true;
      return *best;
    }
    if (label != nullptr) return unknownLabel(*label, kindOfLabel, *derivedTable(m_vocabulary, kindOfLabel));
    if (named) return asked(*named);
    return unknownSize(trials);
  }

  [[nodiscard]] Diagnostic unknownSize(const std::vector<TableTrial>& trials) const {
    std::vector<std::string> sizes;
    for (const TableTrial& tried : trials) {
      if (tried.isDefined())
        sizes.push_back(translated("%1 is %2", {paperMatrixSymbol(tried.right().kind),
                                                sizeText(tried.right().height(), tried.right().width())}));
    }
    return faultAt(m_table.cells.front().front(),
                   translated("No matrix of this mechanism has the size %1: %2.",
                              {sizeText(m_table.rows(), m_table.columns()), listed(sizes, kAllNames)}));
  }

  [[nodiscard]] static Diagnostic unknownLabel(const WrittenCell& label, PaperMatrix kind,
                                               const DerivedTable& right) {
    const auto names = [](const std::vector<Heading>& headings) {
      std::vector<std::string> all;
      for (const Heading& heading : headings) all.push_back(heading.text);
      return listed(all, kMaxNamed);
    };
    return faultAt(
        label,
        translated("%1 is no label of %2, or occurs twice: its rows are %3, its columns %4.",
                   {quoted(label.text), paperMatrixSymbol(kind), names(right.rows), names(right.columns)}));
  }

  [[nodiscard]] Diagnostics undefined(PaperMatrix kind) const {
    const Diagnostics& diagnostics = m_vocabulary.source().snapshot()->diagnostics;
    if (hasErrors(diagnostics)) return diagnostics;
    return {
        faultAt(m_table.cells.front().front(), translated("This mechanism has no %1.", {described(kind)}))};
  }

  [[nodiscard]] static std::string described(PaperMatrix kind) {
    const std::string equation = cited(paperMatrixEquation(kind));
    const std::string title = isEnglish() ? "the " + lowered(std::string(paperMatrixTitle(kind)))
                                          : translated(paperMatrixTitle(kind));
    return title + ' ' + std::string(paperMatrixSymbol(kind)) + (equation.empty() ? "" : ' ' + equation);
  }
  [[nodiscard]] static std::string lowered(std::string text) {
    text.front() = static_cast<char>(text.front() - 'A' + 'a');
    return text;
  }

  const Vocabulary& m_vocabulary;
  const WrittenTable& m_table;
  std::stop_token m_stop;
  WrittenAmounts m_amounts;
};

/// The joints that label the columns of a solution, in order; nothing where they do not all name joints.
std::optional<std::vector<int>> inputsNamed(const Vocabulary& vocabulary, const WrittenTable& table) {
  const Digraph& graph = vocabulary.source().graph();
  std::vector<int> joints;
  for (const WrittenCell& label : table.columnLabels) {
    const JointOrdinal joint = labelNumber(vocabulary, label.text).value_or(-1) - graph.edgeLabel(0);
    if (joint < 0 || joint >= graph.t()) return std::nullopt;
    joints.push_back(joint);
  }
  return joints;
}

/// The mechanism with these joints driven.
Mechanism withInputs(Mechanism mechanism, const std::vector<int>& joints) {
  mechanism.inputs.emplace();
  for (const JointOrdinal joint : joints)
    mechanism.inputs->push_back({mechanism.turningJoints[joint].id, Number{}, {}});
  return mechanism;
}

}  // namespace

std::optional<int> labelNumber(const Vocabulary& vocabulary, const std::string& text) {
  if (const auto name = readName(text); name && Vocabulary::isRate(*name)) {
    std::string fault;
    const auto rates = vocabulary.rate(*name, fault);
    if (!rates || rates->size() != 1 || rates->begin()->second != 1) return std::nullopt;
    return vocabulary.source().graph().edgeLabel(rates->begin()->first);
  }
  std::string digits;
  for (const char c : plainNotation(text)) {
    const bool isDigit = c >= '0' && c <= '9';
    if (isDigit) digits += c;
    if (!isDigit && !digits.empty() && c != '}' && c != ' ' && c != ')') return std::nullopt;
  }
  if (digits.empty() || digits.size() > 6) return std::nullopt;
  return std::stoi(digits);
}

Expected<MatrixVerdict> checkTable(const ExerciseSource& source, const WrittenTable& table,
                                   std::optional<PaperMatrix> kind, const std::stop_token& stop) {
  const Vocabulary vocabulary(source);
  const bool mayBeSolution = !kind || *kind == PaperMatrix::solution;
  const auto inputs = inputsNamed(vocabulary, table);
  const bool isOther =
      mayBeSolution && inputs && source.matroid() != nullptr && !inputs->empty() &&
      static_cast<int>(inputs->size()) == source.matroid()->dof &&
      !std::is_permutation(inputs->begin(), inputs->end(), source.inputs().begin(), source.inputs().end());
  if (isOther && table.rows() == source.graph().t() - source.matroid()->dof) {
    const ExerciseSource driven(withInputs(source.mechanism(), *inputs));
    const bool isValid = driven.matroid() != nullptr && driven.inputs() == *inputs;
    if (!isValid)
      return faultAt(table.columnLabels.front(),
                     translated("These inputs depend on each other, so there is no solution for them."));
    const Vocabulary words(driven);
    return TableCheck(words, table, stop).run(PaperMatrix::solution);
  }
  return TableCheck(vocabulary, table, stop).run(kind);
}

}  // namespace geargraph
