// `check FILE PAPER`: the user's matrices and equations against the derived ones.

#include <algorithm>
#include <array>
#include <iostream>
#include <memory>
#include <set>

#include "app/cli/command.h"
#include "app/cli/diagnostics_output.h"
#include "app/cli/exercise_forms.h"
#include "app/cli/load.h"
#include "app/cli/time_limit.h"
#include "core/foundations/base/text_lists.h"
#include "core/foundations/base/translation.h"
#include "core/foundations/files/file.h"
#include "core/presentation/exporters/element_words.h"
#include "core/teaching/coupling_check/coupling_check.h"
#include "core/teaching/work_check/work_check.h"
#include "core/theory/analysis/analysis.h"

namespace geargraph::cli {
namespace {

/// " (row 3, columns 1 and 2)" of entries in one row or column.
std::string placesText(const WorkDifference& difference) {
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

std::string differenceText(const WorkDifference& difference) {
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
  for (const WorkDifference& difference : verdict.differences) text += differenceText(difference);
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

bool isRight(const WorkVerdict& verdict) {
  if (const auto* matrix = std::get_if<MatrixVerdict>(&verdict)) return matrix->outcome == WorkOutcome::right;
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

/// Which matrices of a controller `--matrix` asks for; std::nullopt for another name or none.
struct ControllerChoice {
  std::optional<CouplingMatrix> alone;  ///< none: both, as JSON
};
std::optional<ControllerChoice> controllerChoice(const Arguments& arguments) {
  const auto name = arguments.value("--matrix");
  if (name == "motor-to-joint") return ControllerChoice{CouplingMatrix::motorToJoint};
  if (name == "joint-to-motor") return ControllerChoice{CouplingMatrix::jointToMotor};
  if (name == "coupling") return ControllerChoice{};
  return std::nullopt;
}

/// The joints that the rows or columns of a controller's matrix are of.
std::variant<std::vector<JointOrdinal>, UsageError> controlledJoints(const AnalysisSnapshot& snapshot,
                                                                     const ExactSolution& exact,
                                                                     const Arguments& arguments) {
  if (const auto named = arguments.value("--outputs")) {
    auto joints = jointsNamed(*snapshot.mechanism, "--outputs", *named);
    const auto* read = std::get_if<std::vector<JointOrdinal>>(&joints);
    if (read != nullptr && read->size() != exact.inputs.size()) {
      return UsageError{translated("There are %1 motors: name as many joints, not %2.",
                                   {std::to_string(exact.inputs.size()), std::to_string(read->size())})};
    }
    return joints;
  }
  return usualJoints(exact, *snapshot.tree, *snapshot.mechanism).value();
}

std::string couplingText(const Mechanism& mechanism, const JointCoupling& coupling,
                         const std::vector<CouplingFinding>& findings) {
  const auto labels = [&](const std::vector<JointOrdinal>& joints) {
    std::vector<std::string> names;
    for (const JointOrdinal joint : joints) names.push_back(std::to_string(mechanism.jointLabel(joint)));
    return listed(names, kAllNames);
  };
  std::string text =
      translated("Motors %1, joints %2", {labels(coupling.motors), labels(coupling.joints)}) + '\n';
  for (const CouplingFinding& each : findings)
    text += "  " + each.sentence + (each.isError ? " [" + std::string(each.name) + ']' : "") + '\n';
  return text;
}

/// A controller's matrices.
int checkController(const Arguments& arguments, Mechanism mechanism, const std::string& path,
                    std::string_view text, const ControllerChoice& choice) {
  const auto written = readWrittenCoupling(text, choice.alone);
  if (!written) {
    std::cerr << diagnosticLines(path, written.error());
    return kUsageOrFile;
  }
  const SnapshotPtr snapshot =
      analyze(std::make_shared<const Mechanism>(std::move(mechanism)), 0, arguments.stop, {false});
  if (!snapshot) return outOfTime(arguments, translated("the check"));
  if (hasErrors(snapshot->diagnostics)) {
    std::cerr << diagnosticLines(arguments.files.front(), snapshot->diagnostics);
    return kMechanismErrors;
  }
  const ExactSolution* const exact =
      snapshot->solved && snapshot->solved->exact ? &*snapshot->solved->exact : nullptr;
  if (exact == nullptr || exact->inputs.empty() || (exact->matrix.empty() && !exact->outputs.empty())) {
    std::cerr << "geargraph-cli check: "
              << translated("There is no solution, because nothing can move or inputs are missing.") << '\n';
    return kMechanismErrors;
  }
  auto joints = controlledJoints(*snapshot, *exact, arguments);
  if (const auto* error = std::get_if<UsageError>(&joints)) return wrongUsage(kCheck, error->message);
  const auto coupling = jointCoupling(*exact, std::get<std::vector<JointOrdinal>>(std::move(joints)));
  if (!coupling) {
    return wrongUsage(kCheck, translated("The speeds of these joints do not determine those of the motors."));
  }
  if (written->size != coupling->size()) {
    return wrongUsage(kCheck, translated("The matrices have %1 rows, the train has %2 motors.",
                                         {std::to_string(written->size), std::to_string(coupling->size())}));
  }
  const auto findings = checkWrittenCoupling(*snapshot->mechanism, *coupling, *written);
  const bool isWrong =
      std::any_of(findings.begin(), findings.end(), [](const CouplingFinding& each) { return each.isError; });
  const int status = isWrong ? kMechanismErrors : kFine;
  if (arguments.has("--json"))
    return print(couplingCheckJson(*snapshot->mechanism, *coupling, findings), status);
  return print(couplingText(*snapshot->mechanism, *coupling, findings), status);
}

int runCheck(const Arguments& arguments) {
  if (arguments.files.size() != 2)
    return wrongUsage(kCheck, translated("A mechanism and a file with a matrix or equations are needed."));
  const auto choice = controllerChoice(arguments);
  const auto kind = choice ? std::optional<PaperMatrix>() : matrixFrom(arguments);
  if (const auto* error = std::get_if<UsageError>(&kind)) return wrongUsage(kCheck, error->message);
  const auto loaded = loadOrSay(arguments.files.front(), kCheck);
  if (const int* status = std::get_if<int>(&loaded)) return *status;
  const std::string& path = arguments.files[1];
  const auto text = readFile(path, kLargestPaper);
  if (const auto* error = std::get_if<FileError>(&text)) return fileFailure(error->message);
  const auto& mechanism = std::get<Mechanism>(loaded);
  const auto& bytes = std::get<std::string>(text);
  if (choice || (!arguments.has("--matrix") && isWrittenCoupling(bytes)))
    return checkController(arguments, mechanism, path, bytes, choice.value_or(ControllerChoice{}));
  if (arguments.has("--outputs"))
    return wrongUsage(kCheck, translated("--outputs belongs to the matrices of a controller."));
  if (mechanism.n() > kMaxExerciseLinks) return tooLargeForExercises();
  const ExerciseSource source(mechanism);
  const auto verdict = checkPaper(source, bytes, std::get<0>(kind), arguments.stop);
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
            "or solution (recognised); of a controller: motor-to-joint, joint-to-motor, or coupling for both "
            "as "
            "JSON")},
    Option{
        "--outputs", "10,12,14",
        toTranslate("of a controller: the joints of its rows or columns, by label (as export --to coupling "
                    "takes them)")},
    Option{"--json", "", toTranslate("as JSON")},
};

}  // namespace

const Command kCheck = {
    "check",
    "FILE PAPER [--matrix NAME] [--outputs 10,12,14] [--json]",
    toTranslate("Compares a matrix or equations of yours with the derived ones; status 1 where they differ."),
    kCheckOptions,
    runCheck,
    false,
    false};

}  // namespace geargraph::cli
