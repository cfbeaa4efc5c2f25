#include "core/teaching/derivation/quantity_table.h"

#include <array>
#include <charconv>

#include "core/foundations/base/contract.h"
#include "core/foundations/base/locale.h"
#include "core/foundations/base/readable.h"
#include "core/foundations/base/translation.h"
#include "core/teaching/derivation/quantity_tables.h"

namespace geargraph {

const std::vector<QuantityKind>& allQuantityKinds() {
  static const std::vector<QuantityKind> kinds = {QuantityKind::screws, QuantityKind::coefficients,
                                                  QuantityKind::solution, QuantityKind::ttCircuits,
                                                  QuantityKind::ttCutsets};
  return kinds;
}

std::string_view quantitySymbol(QuantityKind kind) {
  constexpr std::array<std::string_view, 5> kSymbols = {"û", "P", "θ̇", "B", "Q′"};
  return kSymbols.at(static_cast<std::size_t>(kind));
}

std::string_view quantityTitle(QuantityKind kind) {
  constexpr std::array<std::string_view, 5> kTitles = {
      toTranslate("Screws"), toTranslate("Coefficient matrix"), toTranslate("Solution"),
      toTranslate("T-T circuit matrix"), toTranslate("T-T cutset matrix")};
  return kTitles.at(static_cast<std::size_t>(kind));
}

PaperEquation quantityEquation(QuantityKind kind, EntryForm form) {
  const bool isSymbolic = form == EntryForm::symbols;
  switch (kind) {
    case QuantityKind::screws:
      return PaperEquation::screw;
    case QuantityKind::coefficients:
      return isSymbolic ? PaperEquation::equationsInRatios : PaperEquation::coefficientsInNumbers;
    case QuantityKind::solution:
      return isSymbolic ? PaperEquation::matroidSolution : PaperEquation::solutionByInverse;
    case QuantityKind::ttCircuits:
    case QuantityKind::ttCutsets:
      break;
  }
  return PaperEquation::none;
}

std::string_view quantityCommandName(QuantityKind kind) {
  constexpr std::array<std::string_view, 5> kNames = {"screw", "p", "solution", "tt-circuits", "tt-cutsets"};
  return kNames.at(static_cast<std::size_t>(kind));
}

std::string_view quantityAsciiName(QuantityKind kind) {
  constexpr std::array<std::string_view, 5> kNames = {"U", "P", "S", "B", "Qtt"};
  return kNames.at(static_cast<std::size_t>(kind));
}

std::optional<QuantityEntry> QuantityTable::entry(int row, int column) const {
  for (QuantityEntry& entry : this->row(row)) {
    if (entry.column == column) return std::move(entry);
  }
  return std::nullopt;
}

std::vector<EntryForm> formsOf(const AnalysisSnapshot& snapshot, QuantityKind kind) {
  if (!snapshot.kinematics || !snapshot.kinematics->model) return {};
  switch (kind) {
    case QuantityKind::screws:
      return {EntryForm::decimals, EntryForm::fractions};
    case QuantityKind::coefficients:
      return {EntryForm::decimals, EntryForm::fractions, EntryForm::symbols};
    case QuantityKind::solution: {
      const MatroidAnalysis* matroid = snapshot.matroid();
      if (matroid == nullptr || !matroid->solution) return {};
      std::vector<EntryForm> forms;
      const std::size_t entries = matroid->solution->inputs.size() * matroid->solution->outputs.size();
      if (matroid->solution->matrix.size() == entries) forms.push_back(EntryForm::decimals);
      if (!snapshot.solved || !snapshot.solved->exact) return forms;
      if (snapshot.solved->exact->matrix.size() == entries) forms.push_back(EntryForm::fractions);
      if (snapshot.solved->symbolic && snapshot.solved->symbolic->matrix.size() == entries) {
        forms.push_back(EntryForm::symbols);
      }
      return forms;
    }
    case QuantityKind::ttCircuits:
    case QuantityKind::ttCutsets:
      if (!snapshot.kinematics->ttGraph || !snapshot.kinematics->ttGraph->isComplete()) return {};
      return {EntryForm::fractions};
  }
  GEARGRAPH_REQUIRE(false);
}

QuantityTablePtr quantityTable(const SnapshotPtr& snapshot, QuantityKind kind, EntryForm form) {
  const std::vector<EntryForm> forms = formsOf(*snapshot, kind);
  if (std::find(forms.begin(), forms.end(), form) == forms.end()) return nullptr;
  switch (kind) {
    case QuantityKind::screws:
      return screwTable(snapshot, form);
    case QuantityKind::coefficients:
      return coefficientTable(snapshot, form);
    case QuantityKind::solution:
      return solutionTable(snapshot, form);
    case QuantityKind::ttCircuits:
      return ttCircuitTable(snapshot);
    case QuantityKind::ttCutsets:
      return ttCutsetTable(snapshot);
  }
  GEARGRAPH_REQUIRE(false);
}

std::string latexOf(const Rational& value) {
  const std::string text = value.toString();
  const std::size_t slash = text.find('/');
  if (slash == std::string::npos) return text;
  const bool negative = text.front() == '-';
  return (negative ? "-\\frac{" : "\\frac{") + text.substr(negative ? 1 : 0, slash - (negative ? 1 : 0)) +
         "}{" + text.substr(slash + 1) + "}";
}

std::string readableLatex(const Rational& value) {
  return isLongFraction(value.toString()) ? spokenTexNumber(shortDecimal(value.toDouble())) : latexOf(value);
}

std::string readableLatex(const QuantityEntry& entry) {
  const bool isLong = !entry.isFormula && isLongFraction(entry.text);
  return isLong ? spokenTexNumber(shortDecimal(entry.value)) : entry.latex;
}

std::string shortDecimal(double value) {
  std::array<char, 32> digits{};
  const auto end =
      std::to_chars(digits.data(), digits.data() + digits.size(), value + 0.0, std::chars_format::general, 6);
  return {digits.data(), end.ptr};
}

QuantityEntry decimalEntry(int column, double value) {
  const std::string text = shortDecimal(value);
  return {column, text, spokenTexNumber(text), value, false};
}

QuantityEntry fractionEntry(int column, const Rational& value) {
  return {column, value.toString(), latexOf(value), value.toDouble(), false};
}

QuantityEntry irrationalEntry(int column, double value) {
  const std::string text = shortDecimal(value);
  return {column, "≈ " + text, "\\approx " + spokenTexNumber(text), value, false};
}

}  // namespace geargraph
