// `check FILE PAPER`: the user's matrices and equations against the derived ones.

#include <array>
#include <iostream>
#include <set>

#include "app/cli/command.h"
#include "app/cli/diagnostics_output.h"
#include "app/cli/exercise_forms.h"
#include "app/cli/load.h"
#include "app/cli/time_limit.h"
#include "core/foundations/base/wording.h"
#include "core/foundations/base/words.h"
#include "core/foundations/files/file.h"
#include "core/teaching/paper_check/paper_check.h"

namespace geargraph::cli {
namespace {

/// " (row 3, columns 1 and 2)" of entries in one row or column.
std::string placesText(const PaperDifference& difference) {
  std::set<int> rows;
  std::set<int> columns;
  for (const EntryPlace& place : difference.entries) {
    rows.insert(place.row + 1);
    columns.insert(place.column + 1);
  }
  if (rows.empty()) return {};
  const auto numbered = [](const char* one, const char* many, const std::set<int>& numbers) {
    std::vector<std::string> names;
    for (const int number : numbers) names.push_back(std::to_string(number));
    return filled(translated(names.size() > 1 ? many : one), {listed(names, 8)});
  };
  return " (" + numbered(toTranslate("row %1"), toTranslate("rows %1"), rows) + ", " +
         numbered(toTranslate("column %1"), toTranslate("columns %1"), columns) + ')';
}

std::string differenceText(const PaperDifference& difference) {
  return "  " + translated(paperMistakeTitle(difference.name)) + placesText(difference) + ": " +
         difference.reason + " [" + difference.name + "]\n";
}

std::string asText(const MatrixVerdict& verdict) {
  std::string text = translated(paperMatrixTitle(verdict.kind));
  text += ' ' + std::string(paperMatrixSymbol(verdict.kind));
  if (const std::string number = cited(paperMatrixEquation(verdict.kind)); !number.empty())
    text += ' ' + number;
  text += ": " + translated(outcomeName(verdict.outcome)) + '\n';
  for (const std::string& note : verdict.notes) text += "  " + note + '\n';
  for (const PaperDifference& difference : verdict.differences) text += differenceText(difference);
  return text;
}

std::string asText(const std::vector<EquationVerdict>& verdicts) {
  std::string text;
  for (const EquationVerdict& verdict : verdicts) {
    text += std::to_string(verdict.line) + ": " + verdict.text + ": " +
            (verdict.isRight ? translated("right") : translated("wrong")) + '\n';
    if (verdict.difference) text += differenceText(*verdict.difference);
  }
  return text;
}

bool isRight(const PaperVerdict& verdict) {
  if (const auto* matrix = std::get_if<MatrixVerdict>(&verdict))
    return matrix->outcome == PaperOutcome::right;
  const auto& equations = std::get<std::vector<EquationVerdict>>(verdict);
  return std::all_of(equations.begin(), equations.end(), [](const EquationVerdict& e) { return e.isRight; });
}

std::variant<std::optional<PaperMatrix>, UsageError> matrixFrom(const Arguments& arguments) {
  const auto name = arguments.value("--matrix");
  if (!name) return std::optional<PaperMatrix>();
  if (const auto kind = paperMatrixFromName(*name)) return kind;
  std::vector<std::string> names;
  for (const PaperMatrix kind : allPaperMatrices()) names.emplace_back(paperMatrixName(kind));
  return UsageError{
      translated("There is no matrix \"%1\": %2.", {*name, listed(names, kAllNames, toTranslate("or"))})};
}

int runCheck(const Arguments& arguments) {
  if (arguments.files.size() != 2)
    return wrongUsage(kCheck, translated("A mechanism and a file with a matrix or equations are needed."));
  const auto kind = matrixFrom(arguments);
  if (const auto* error = std::get_if<UsageError>(&kind)) return wrongUsage(kCheck, error->message);
  const auto loaded = loadOrSay(arguments.files.front());
  if (const int* status = std::get_if<int>(&loaded)) return *status;
  const std::string& path = arguments.files[1];
  const auto text = readFile(path, kLargestPaper);
  if (const auto* error = std::get_if<FileError>(&text)) return fileFailure(error->message);
  const auto& mechanism = std::get<Mechanism>(loaded);
  if (mechanism.n() > kMaxExerciseLinks) return tooLargeForExercises();
  const ExerciseSource source(mechanism);
  const auto verdict = checkPaper(source, std::get<std::string>(text), std::get<0>(kind), arguments.stop);
  if (arguments.stop.stop_requested()) return outOfTime(arguments, translated("the check"));
  if (!verdict) {
    const bool isOfPaper = verdict.error().front().line > 0;
    std::cerr << diagnosticLines(isOfPaper ? path : arguments.files.front(), verdict.error());
    return isOfPaper ? kUsageOrFile : kMechanismErrors;
  }
  const int status = isRight(*verdict) ? kFine : kMechanismErrors;
  if (arguments.has("--json")) return print(verdictJson(*verdict), status);
  return print(std::visit([](const auto& which) { return asText(which); }, *verdict), status);
}

constexpr std::array kCheckOptions = {
    Option{
        "--matrix", "NAME",
        toTranslate(
            "which matrix it is: incidence, reduced-incidence, path, spanning-tree, cycle-basis, cutset, p "
            "or solution (recognised)")},
    Option{"--json", "", toTranslate("as JSON")},
};

}  // namespace

const Command kCheck = {
    "check",
    "FILE PAPER [--matrix NAME] [--json]",
    toTranslate("Compares a matrix or equations of yours with the derived ones; status 1 where they differ."),
    kCheckOptions,
    runCheck,
    false,
    false};

}  // namespace geargraph::cli
